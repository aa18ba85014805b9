#pragma once

#include <span>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// One sighting of the object by a camera that measures range and bearing.
struct Sighting {
  double time = 0.0;     ///< [s]
  Vec2 from;             ///< [m] position of the camera
  double bearing = 0.0;  ///< [rad] in the world frame: the robot's heading plus the camera's pan
  double range = 0.0;    ///< [m]
};

/// The place [m] at which the object is seen.
Vec2 placeOf(const Sighting& sighting);

/// Standard deviations of a sighting.
struct SightingNoise {
  double range = 0.0;    ///< [m]
  double bearing = 0.0;  ///< [rad]
};

/// An object that moves straight at constant speed.
struct ObjectMotion {
  Vec2 position;  ///< [m] at `time`
  Vec2 velocity;  ///< [m/s]
  double time = 0.0;

  Vec2 at(double when) const { return position + velocity * (when - time); }
};

/// The motion from two sightings: both places, and their difference divided by the time between. The result's
/// time is that of the second sighting. The times must differ.
ObjectMotion fromTwo(const Sighting& first, const Sighting& second);

/// The angles of Choi & Lee (2005), Fig. 11, in the triangle of the robot and two sightings from one place.
struct SightingTriangle {
  double l3 = 0.0;      ///< [m] distance that the object moved, by (17) with its square corrected
  double theta2 = 0.0;  ///< [rad] at the object's first place, (18)
  double theta3 = 0.0;  ///< [rad] at the robot, from the bearings, since (19) repeats (17)
};
SightingTriangle triangleOf(const Sighting& first, const Sighting& second);

/// The object's heading [rad] by that triangle: bearing of the second sighting + s (theta2 + theta3 - pi),
/// with s = 1 if the bearing decreases and -1 if it increases. The printed (21) holds only for a robot's
/// heading of 90 degrees and a decreasing bearing.
double headingByTriangle(const Sighting& first, const Sighting& second);

/// The motion that fits the sightings best by least squares over position and velocity. Each place has the
/// inverse of its covariance under `noise` (along and across the line of sight) as its weight. The result's
/// time is that of the last sighting. Needs two sightings of different times; without noise all weights are
/// equal.
ObjectMotion fitMotion(std::span<const Sighting> sightings, const SightingNoise& noise);

}  // namespace fulbito::capture
