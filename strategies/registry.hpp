#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// A team and its settings: what a seat of a match is given. The entry lives as long as any choice of it.
struct TeamChoice {
  std::shared_ptr<const TeamInfo> info;
  std::string text;  ///< the specification, as recordings and reports name the team
  std::vector<Setting> settings;

  /// A team of one's own, without a catalogue. `make` gives a fresh one for every match, also from several
  /// threads at once.
  static TeamChoice own(std::string name, std::function<std::unique_ptr<Strategy>()> make);
};

/// The teams that a specification may name: a value. Copies share their entries, which never change.
class TeamCatalogue {
 public:
  /// All built-in teams, in the order in which tables list them.
  static TeamCatalogue builtIn();

  /// Adds a team at the end. Errors: kUsage when the name is empty, taken, or has a ':' or ',' in it, and
  /// when the entry makes no team.
  Result<void> add(TeamInfo info);
  const std::vector<std::shared_ptr<const TeamInfo>>& teams() const& { return teams_; }
  /// Of a temporary: moved out, so that a loop over `builtIn().teams()` is safe.
  std::vector<std::shared_ptr<const TeamInfo>> teams() && { return std::move(teams_); }

  /// Takes a specification such as `libero:navigator=bezier,aggression=0.7` apart and checks it. A
  /// navigator's own parameters follow with `+`: `classic:navigator=bezier:clearance=0.03+follower=classic`.
  /// Errors: kUsage naming the unknown team, parameter or navigator, with a suggestion, or the allowed range.
  Result<TeamChoice> parse(const std::string& specification) const;

 private:
  std::vector<std::shared_ptr<const TeamInfo>> teams_;
};

/// `TeamCatalogue::parse` of the built-in teams.
Result<TeamChoice> parseTeam(const std::string& specification);

/// A fresh team for the choice. Errors: kUsage.
Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice);

}  // namespace fulbito
