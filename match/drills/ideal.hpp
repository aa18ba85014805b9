// Private header of match: not installed.
#pragma once

#include "match/drills/drill.hpp"
#include "match/drills/start.hpp"

namespace fulbito {

/// Least time [s] in which the tested team's first robot could do what the scene asks for, as far as the
/// formulas of time to reach go; 0 where there is none.
double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config);

/// Time [s] to a point at `distance` [m] for a robot at rest whose heading is off by `bearing` [rad]:
/// 1.4 sqrt(phi b / 2a) to turn, phi folded to 0 ... pi/2 as both ends drive, then full acceleration.
double timeToReach(const RobotModel& robot, double distance, double bearing);

/// Time [s] to turn by `angle` [rad] in place, from rest to rest: both rims at full torque.
double timeToTurn(const RobotModel& robot, double angle);

}  // namespace fulbito
