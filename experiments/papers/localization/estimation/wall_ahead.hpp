#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// The wall that a sensor faces, and how its echo depends on the pose. Since a sensor hears the perpendicular
/// within its cone, the range is the distance from the sensor to the wall.
struct WallAhead {
  bool across_x = true;     ///< a wall x = constant; otherwise y = constant
  double sign = 1.0;        ///< 1: the wall at the far end of that axis; -1: the one through the origin
  double distance = 0.0;    ///< [m] from the sensor to the wall; negative beyond it
  double incidence = 0.0;   ///< [rad] between the sensor's axis and the perpendicular
  double by_heading = 0.0;  ///< [m/rad] change of the distance with the robot's heading
};

WallAhead wallAhead(const Room& room, const Body& body, const Pose2& pose, Beam beam);

}  // namespace fulbito::localization
