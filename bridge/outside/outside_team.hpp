#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/outside/bounded_log.hpp"
#include "bridge/process/child.hpp"
#include "bridge/team_codec.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// A team in a child process, and the encoding of the conversation with it.
struct OutsideTeamSetup {
  ChildOptions child;                                 ///< the program and its containment
  std::function<std::unique_ptr<TeamCodec>()> codec;  ///< the encoding of the conversation
  std::vector<Setting> settings;                      ///< the team's settings
  std::function<std::int64_t()> clock;                ///< monotonic time [ns]
  TeamLog log;  ///< takes up to `BoundedLog::kMost` bytes of standard error per match; empty: it is dropped
};

/// A team in a child process. A team that ends, breaks the protocol or starts too late has failed: it starts
/// again while play goes on, until it has failed too often (`DecisionTime::failures`). Only one decision is
/// asked at a time: a team that is late gets the newest observation as soon as it has answered.
class OutsideTeam : public Strategy {
 public:
  explicit OutsideTeam(OutsideTeamSetup setup);
  ~OutsideTeam() override;
  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override;
  void allow(double seconds) override;
  void ask(const Observation& observation) override;
  TeamCommand decide(const Observation& observation) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  void stopped(const PlayStop& stop) override;
  void ready(const Observation& observation) override;
  void ended(const MatchEnd& end) override;
  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override;
  const TeamCondition& condition() const override;
  std::vector<Setting> origin() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Adds what a program is contained by to the origin of a team.
void addContainment(const Containment& reached, std::vector<Setting>& origin);

}  // namespace fulbito
