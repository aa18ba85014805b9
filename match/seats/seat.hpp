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

/// What a seat needs to know of the tick to be sensed.
struct Moment {
  Tick tick = 0;
  const WorldState* world = nullptr;  ///< null before the first placement
  std::span<const RobotId> ids;
  const RefereeState* referee = nullptr;
};

/// One side of a match: a team with its eyes, its navigation stage and the policy for what it commands.
class Seat {
 public:
  /// Errors: of the team and its navigators.
  static Result<Seat> create(const MatchConfig& config, TeamId team);

  /// Play begins anew in this world.
  void reset(const Moment& moment);
  /// Looks at the world: fills in what the team may know at this tick.
  void sense(const Moment& moment);
  /// What everybody can see while play is stopped: the truth, whatever the team's vision.
  Observation exactly(const Moment& moment) const;
  /// The same with the restart to come.
  Observation before(const RestartCall& call, double delay, const Moment& moment) const;
  /// Whether drawings of the decision to come are wanted.
  void wantDrawings(bool wanted) { observation_.wants_drawings = wanted; }
  /// Asks the team for its decision.
  TeamCommand decide() { return strategy_->decide(observation_); }
  /// Whether a decision that took `seconds` came too late.
  bool late(double seconds) { return time_ && time_->late(seconds, observation_.period); }
  /// Wheel speeds of the team's robots by the decision that holds, before they are cut and rounded.
  std::array<WheelSpeeds, kMaxTeamSize> drive();
  /// What the navigators wanted in the last `drive`, where drawings were wanted.
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
