#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/oddities.hpp"
#include "fulbito/match.hpp"
#include "fulbito/world.hpp"

namespace fulbito::simulator {

/// Where robots and ball stand when there is no referee: at the match's start, or as at its first kick-off.
Placement startOf(const MatchConfig& config);

/// A field as the league's simulator has it: no rules, and whoever asks may move robots and ball.
///
/// A robot that is off is not in vision, and its wheels stand; its body stays. Overlaps are the engine's: it
/// pushes bodies apart. What is put outside of the walls stands there, untouchable, until it is put
/// elsewhere.
class SimulatedField {
 public:
  /// The wheel speeds in force [rad/s], by team and number.
  using Wheels = PerTeam<std::array<WheelSpeeds, kMaxTeamSize>>;

  /// Takes field, robots, ball, physics and team size of the match. Robots without a place are off.
  /// Errors: as `World::create`.
  static Result<SimulatedField> create(const MatchConfig& config, const Placement& start);

  /// Moves what the packet says. Notes and drops what there is not, or is not finite. @return obeyed: robots
  /// and ball
  int replace(const wire::Packet& packet, wire::OddityLog& oddities);
  /// Runs one tick. Errors: as `World::create`.
  Result<void> step(const Wheels& wheels);

  /// A frame of all robots that are on; its score is 0.
  wire::Vision vision() const;
  /// The robots of a team that are on, bit by number.
  std::uint32_t on(TeamId team) const;
  /// The robots of a team that have gone off since the last tick, likewise.
  std::uint32_t wentOff(TeamId team) const;

 private:
  struct Robot {
    RobotState state;
    bool on = false;
    bool was_on = false;  ///< at the last tick
    bool inside = false;  ///< it is a body of the world
  };

  explicit SimulatedField(const MatchConfig& config);
  bool put(const wire::RobotReplacement& wish, wire::OddityLog& oddities);
  void put(const wire::BallReplacement& wish);
  Result<void> build();
  void read();

  MatchConfig config_;
  PerTeam<std::vector<Robot>> robots_;  ///< by number
  BallState ball_;
  bool ball_inside_ = false;  ///< it is a body of the world
  std::optional<World> world_;
  bool moved_ = true;                  ///< something was put elsewhere since the world was built
  std::vector<WheelSpeeds> commands_;  ///< in the order of the world's robots
};

}  // namespace fulbito::simulator
