#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// The wall that a sensor faces, and how its echo follows from the pose. Within its cone a sensor hears the
/// perpendicular, so the range is the distance of the sensor itself from the wall.
struct WallAhead {
  bool across_x = true;     ///< a wall x = constant; otherwise y = constant
  double sign = 1.0;        ///< 1: the wall at the room's end of that axis; -1: the one through the origin
  double distance = 0.0;    ///< [m] of the sensor from the wall; negative behind it
  double incidence = 0.0;   ///< [rad] between the sensor's axis and the perpendicular
  double by_heading = 0.0;  ///< [m/rad] change of the distance with the robot's heading
};

WallAhead wallAhead(const Room& room, const Body& body, const Pose2& pose, Beam beam);

}  // namespace fulbito::localization
