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

/// One seat of a match: a team with its vision, its navigation stage and the policy for its commands. In a
/// tick `sense`, `ask`, `decide`, `clean` and `drive` follow each other, see `Seats::play`.
class Seat {
 public:
  /// @param late  ticks that observations are old before the team's vision delays them, so that it is told
  /// Errors: of the team and its navigators; as `cut`.
  static Result<Seat> create(const MatchConfig& config, TeamId team, const MatchClock& clock, int late = 0);

  /// Starts a new play in this world.
  void reset(const Moment& moment);
  /// The observation while play is stopped: the true state, without the errors of the team's vision.
  Observation exactly(const Moment& moment) const;
  /// The observation while play is stopped, with the next restart.
  Observation before(const RestartCall& call, double delay, const Moment& moment) const;
  /// The team's wishes for a restart; empty if it has none or is late.
  std::optional<TeamProposal> place(const PlacementRequest& request);

  /// Fills in the team's observation at this tick.
  /// @param drawings whether the decision includes drawings
  void sense(const Moment& moment, bool drawings);
  /// Gives the team the observation, so that a team in another process begins to think.
  void ask();
  /// Lets the team decide.
  void decide();
  /// Repairs the team's decision and puts it in force, unless it was late.
  void clean(const GameEvent& now, std::vector<GameEvent>& events);
  /// Counts the failures of a team outside the program.
  void countFailures(const GameEvent& now, std::vector<GameEvent>& events) {
    policy_.count(strategy_->condition(), now, events);
  }
  /// Whether the team failed too often and forfeits the match.
  bool lost() const { return strategy_->condition().state == TeamCondition::State::kLost; }
  /// The reason why the match must stop, if the machine lacks resources for the team: kMachine; kInterrupted.
  std::optional<Error> cut() const;
  /// Computes the wheel speeds of the team's robots by the decision in force, within the limits of the motors
  /// and in whole steps: 0 while the robots are held. They are part of the next observation.
  /// @param commands one per robot of `ids`
  void drive(std::span<const RobotId> ids, bool held, std::span<WheelSpeeds> commands);

  /// The decision in force.
  const TeamCommand& command() const { return policy_.command(); }
  /// The team's faults so far.
  const TeamFaults& faults() const { return policy_.faults(); }
  /// Drawings of the navigators in the last `drive`; empty if no drawings are wanted.
  std::span<const DebugDrawing> ways() const { return ways_; }
  Strategy& strategy() { return *strategy_; }

 private:
  Seat(const MatchConfig& config, TeamId team, int late, const MatchClock& clock,
       std::unique_ptr<Strategy> strategy, TeamPilots pilots, CommandPolicy policy);
  void allow();
  template <typename Answer>
  bool inTime(const Answer& answer);
  void fillRobots(const Moment& moment, std::span<const RobotState> robots, Side side,
                  Observation& seen) const;
  void fillReferee(const Moment& moment, Observation& seen) const;

  TeamId team_;
  int latency_ticks_;
  MatchClock clock_;
  std::unique_ptr<Strategy> strategy_;
  TeamPilots pilots_;
  CommandPolicy policy_;
  std::optional<ThinkingTime> time_;  ///< empty: unlimited
  std::optional<Vision> vision_;      ///< empty: the team sees the true state
  Observation observation_;
  TeamCommand decision_;
  bool in_time_ = false;  ///< the decision is in time
  std::vector<DebugDrawing> ways_;
};

}  // namespace fulbito
