#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fulbito/strategy.hpp"
#include "match/seats/policy.hpp"
#include "match/seats/thinking_time.hpp"
#include "match/seats/vision.hpp"
#include "referee/match/match_referee.hpp"
#include "strategies/team_pilots.hpp"

namespace fulbito {

/// The state of a match at one tick, as the source of observations.
struct Moment {
  Tick tick = 0;                          ///< tick of the match
  const WorldState* world = nullptr;      ///< null before the first placement
  std::span<const RobotId> ids;           ///< robots of the world
  const RefereeState* referee = nullptr;  ///< the referee's state
};

/// One seat of a match: a team with its vision, its navigation stage and the policy for its commands.
class Seat {
 public:
  /// Errors: of the team and its navigators; as `cut`.
  static Result<Seat> create(const MatchConfig& config, TeamId team);

  /// A new play begins in this world.
  void reset(const Moment& moment);
  /// Fills in the team's observation at this tick.
  void sense(const Moment& moment);
  /// The observation while play is stopped: the true state, whatever the team's vision.
  Observation exactly(const Moment& moment) const;
  /// The observation while play is stopped, with the next restart.
  Observation before(const RestartCall& call, double delay, const Moment& moment) const;
  /// Sets whether the next decision includes drawings.
  void wantDrawings(bool wanted) { observation_.wants_drawings = wanted; }
  /// Whether the team's time is limited.
  bool limited() const { return time_.has_value(); }
  /// Tells the team how long its next answer may take.
  void allow();
  /// Gives the team the observation, so that a team in another process begins to think.
  void ask();
  /// Asks the team for its decision.
  TeamCommand decide() { return strategy_->decide(observation_); }
  /// Charges the team for an answer of `seconds`, unless it measured that itself.
  /// @return whether the answer counts: it came in time, from a team that is well
  bool inTime(double seconds);
  /// Why the match cannot go on with the team, if the machine failed it: kMachine; kInterrupted.
  std::optional<Error> cut() const;
  /// Wheel speeds of the team's robots by the decision in force, before clamping and rounding.
  std::array<WheelSpeeds, kMaxTeamSize> drive();
  /// Drawings of the navigators in the last `drive`; empty unless drawings are wanted.
  std::span<const DebugDrawing> ways() const { return ways_; }

  /// Records the command actually applied to a robot: part of the next observation.
  void recordSent(std::uint8_t number, WheelSpeeds command) { observation_.sent[number] = command; }

  CommandPolicy& policy() { return policy_; }
  const CommandPolicy& policy() const { return policy_; }
  Strategy& strategy() { return *strategy_; }

 private:
  Seat(const MatchConfig& config, TeamId team, std::unique_ptr<Strategy> strategy, TeamPilots pilots,
       CommandPolicy policy);
  void fillRobots(const Moment& moment, std::span<const RobotState> robots, Side side,
                  Observation& seen) const;
  void fillReferee(const Moment& moment, Observation& seen) const;

  TeamId team_;
  int latency_ticks_;
  std::unique_ptr<Strategy> strategy_;
  TeamPilots pilots_;
  CommandPolicy policy_;
  std::optional<ThinkingTime> time_;  ///< empty: unlimited
  std::optional<Vision> vision_;      ///< empty: the team sees the truth
  Observation observation_;
  std::vector<DebugDrawing> ways_;
};

}  // namespace fulbito
