#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bridge/abi/plugin_team.hpp"
#include "bridge/abi/team_values.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// A team of a shared library that runs in this process. After a failure of `decide`, the robots stop for
/// that tick. `decide` allocates nothing, unless drawings are wanted.
class LibraryTeam final : public Strategy {
 public:
  explicit LibraryTeam(std::unique_ptr<PluginTeam> team);

  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& observation) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void stopped(const PlayStop& stop) override;
  void ready(const Observation& observation) override;
  void ended(const MatchEnd& end) override;
  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override;

  /// The team itself, for its failures.
  const PluginTeam& team() const { return *team_; }

 private:
  std::unique_ptr<PluginTeam> team_;
  std::vector<NavigatorChoice> navigators_;
  CommandRoom room_;
  fulbito_observation seen_{};  ///< of the present tick
};

/// Loads the team of a shared library with the C interface `fulbito/team.h`, to run in this process. The
/// library stays loaded as long as the entry or any team of it lives. Its code is trusted: it can crash or
/// block the process.
/// @param path  the file; without '/', one of the present folder
/// @param log   receives the lines that its teams log, also from several threads at once; empty: they go to
///              standard error
/// @return the entry for a catalogue, named as the library says. Errors, which name the file: kIo if it
/// cannot
///         be read, kBadInput if it is no library with a team for this version of the interface.
Result<TeamInfo> loadTeamLibrary(const std::string& path, PluginLog log = {});

/// The navigator that a team asks for by a specification in which '+' may stand for ','. An unknown one gives
/// a choice whose `make` fails with the error of `parse`, so that the match reports it.
NavigatorChoice navigatorFor(const std::string& specification,
                             Result<NavigatorChoice> (*parse)(const std::string&));

}  // namespace fulbito
