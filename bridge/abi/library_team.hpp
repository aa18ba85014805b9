#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bridge/abi/plugin_team.hpp"
#include "bridge/abi/team_values.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// A team of a shared library that runs in this process. It plays like a team in a process of its own
/// (`OutsideTeam`), as long as its functions return. After a failure of one, a new team starts with the next
/// decision, until the team has failed too often (`DecisionTime::failures`). `decide` allocates nothing,
/// unless drawings are wanted.
class LibraryTeam final : public Strategy {
 public:
  /// Makes a team, anew for each start.
  using Make = std::function<Result<std::unique_ptr<PluginTeam>>()>;

  /// @param first  the team of the first start
  LibraryTeam(std::unique_ptr<PluginTeam> first, Make make);

  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& observation) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void stopped(const PlayStop& stop) override;
  void ready(const Observation& observation) override;
  void ended(const MatchEnd& end) override;
  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override;
  const TeamCondition& condition() const override { return condition_; }
  std::vector<Setting> origin() const override;

 private:
  using State = TeamCondition::State;
  Result<void> start();
  Result<void> takeNavigators();
  void failed(const std::string& reason);
  bool settle();
  /// Whether the team can take a call. If a notice failed, the next request reports the failure.
  bool playing() const { return team_ != nullptr && condition_.state != State::kLost; }

  Make make_;
  std::unique_ptr<PluginTeam> team_;  ///< null after a failure, until the next start
  MatchInfo info_;
  std::string name_, version_;
  bool begun_ = false;  ///< the first start is over
  TeamCondition condition_;
  std::vector<NavigatorChoice> navigators_;
  std::vector<std::string> navigator_names_;
  CommandRoom room_;
  fulbito_observation seen_{};  ///< observation of the present tick
};

/// Loads the team of a shared library with the C interface `fulbito/team.h`, to run in this process. The
/// library stays loaded as long as the entry or any team of it lives. Its code is trusted: it can crash or
/// block the process.
/// @param path  the file; without '/', a file of the working directory
/// @param log   receives the lines that its teams log, also from several threads at once; empty: they go to
///              standard error
/// @return the entry for a catalogue, with the library's name. Errors, which name the file: kIo if it cannot
/// be read, kBadInput if it is no library with a team for this version of the interface.
Result<TeamInfo> loadTeamLibrary(const std::string& path, PluginLog log = {});

/// The navigator that a team asks for by a specification in which '+' may stand for ','. An unknown one gives
/// a choice whose `make` fails with the error of `parse`, so that the match reports it.
NavigatorChoice navigatorFor(const std::string& specification,
                             Result<NavigatorChoice> (*parse)(const std::string&));

}  // namespace fulbito
