#pragma once

#include <memory>
#include <vector>

#include "fulbito/navigation.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/foresight.hpp"

namespace fulbito {

/// The navigation stage of one team: turns its command into wheel speeds. Every robot has a pilot of its own
/// for each of the strategy's navigators; a pilot that was not used in the tick before starts anew. Old
/// observations are made current first.
class TeamPilots {
 public:
  /// Errors: as `makePilot`.
  static Result<TeamPilots> create(const MatchInfo& info, std::span<const NavigatorChoice> navigators);
  /// Forgets everything: play was begun anew.
  void reset();
  /// Wheel speeds [rad/s] of every robot, 0 for absent ones and for `kGoTo` without such a navigator. What it
  /// works out is rounded to 256 speeds each way, e.g. steps of 0.18 rad/s of the robot `vsss`.
  /// kWheels are passed on as they are, even when they are not finite: what to do then is the match's policy.
  std::array<WheelSpeeds, kMaxTeamSize> drive(const Observation& observation, const TeamCommand& command);
  /// Appends what the navigators of the last `drive` wanted: paths, arrows of fields, places to drive to.
  void draw(const Observation& observation, const TeamCommand& command,
            std::vector<DebugDrawing>& drawings) const;

 private:
  void warmUp();

  struct Driver {
    std::vector<std::unique_ptr<Pilot>> pilots;
    int last = -1;          ///< pilot of the tick before
    bool backward = false;  ///< its back leads
  };
  WheelSpeeds driveRobot(const Observation& observation, int robot, const RobotCommand& wanted);
  WheelSpeeds goTo(const Observation& observation, int robot, const GoTo& go_to);
  WheelSpeeds inSteps(WheelSpeeds wheels) const;

  void chooseFront(Driver& driver, const RobotState& robot, const GoTo& go_to) const;

  MatchInfo info_;
  double step_ = 0.0;  ///< [rad/s] of the commands
  double top_ = 0.0;   ///< [rad/s] the fastest in whole steps
  Foresight foresight_;
  std::vector<Driver> drivers_;
  std::vector<DiscObstacle> discs_;
  RobotModel steady_;  ///< the robot as twists are limited for it
  RobotModel slowed_;  ///< the robot with the speed limit of the moment
};

}  // namespace fulbito
