#pragma once

#include <memory>
#include <vector>

#include "fulbito/navigation.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/foresight.hpp"

namespace fulbito {

/// The navigation stage of one team: turns its command into wheel speeds. Every robot has its own pilot for
/// each navigator of the strategy. A pilot that was not used in the previous tick starts without memory. Old
/// observations are predicted to the present first.
class TeamPilots {
 public:
  /// Errors: as `makePilot`.
  static Result<TeamPilots> create(const MatchInfo& info, std::span<const NavigatorChoice> navigators);
  /// Forgets all state, for the start of a new play.
  void reset();
  /// Wheel speeds [rad/s] of every robot: 0 for absent robots and for `kGoTo` with an unknown navigator.
  /// Computed speeds are rounded to 256 steps in each direction, e.g. of 0.18 rad/s for the robot `vsss`.
  /// kWheels pass unchanged, even if they are not finite, since the match decides what to do then.
  std::array<WheelSpeeds, kMaxTeamSize> drive(const Observation& observation, const TeamCommand& command);
  /// Appends the guidance of the last `drive`: paths, arrows of fields, targets.
  void draw(const Observation& observation, const TeamCommand& command,
            std::vector<DebugDrawing>& drawings) const;

 private:
  void warmUp();

  struct Driver {
    std::vector<std::unique_ptr<Pilot>> pilots;
    int last = -1;          ///< index of the pilot used in the previous tick; -1: none
    bool backward = false;  ///< the robot's back leads
  };
  WheelSpeeds driveRobot(const Observation& observation, int robot, const RobotCommand& wanted);
  WheelSpeeds goTo(const Observation& observation, int robot, const GoTo& go_to);
  WheelSpeeds inSteps(WheelSpeeds wheels) const;

  void chooseFront(Driver& driver, const RobotState& robot, const GoTo& go_to) const;

  MatchInfo info_;
  double step_ = 0.0;  ///< [rad/s] resolution of the wheel commands
  double top_ = 0.0;   ///< [rad/s] greatest command that is a whole number of steps
  Foresight foresight_;
  std::vector<Driver> drivers_;
  std::vector<DiscObstacle> discs_;
  RobotModel steady_;  ///< robot model for the limits of twists
  RobotModel slowed_;  ///< robot model with the present speed limit
};

}  // namespace fulbito
