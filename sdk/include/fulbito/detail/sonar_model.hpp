#pragma once

#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Mount and range of an ultrasonic sensor on a robot. It hears within a cone about its axis.
struct SonarSpec {
  Pose2 mount;  ///< robot frame: its membrane, and the direction of its axis
  double half_cone =
      0.21817;  ///< [rad] between the axis and the edge of the cone, below pi / 2; 12.5 degrees
  /// [m] nearer echoes arrive while the membrane still rings: the sonar reports this range
  double least = 0.0;
  double greatest = 1.0;  ///< [m] farther echoes are too faint
};

/// The ultrasonic sensors of a robot and their errors. All fire once per reading.
struct SonarModel {
  std::vector<SonarSpec> sonars;
  double noise = 0.0;    ///< [m] standard deviation of a range
  double dropout = 0.0;  ///< probability that a sonar misses an echo
  /// [rad] Largest angle between a smooth face's normal and the direction to the sonar at which the face
  /// still reflects an echo to it. Beyond it, the sound goes off sideways. pi / 2: rough faces, nothing is
  /// lost.
  double specular_limit = 0.5236;
  /// Probability that a sonar also hears the call of its neighbours in the list, and takes that echo for its
  /// own if it comes earlier. 0: they fire one after the other.
  double cross_talk = 0.0;
};

/// A reading of one sonar.
struct SonarReading {
  bool heard = false;  ///< whether there was an echo
  /// [m] from the membrane to the place of the echo; the sonar's `greatest` without an echo
  double range = 0.0;
};

/// Radius [m] of the robot of P.-G. Kim et al. (2006), a Pioneer.
inline constexpr double kPioneerRadius = 0.22;

/// Scale of `robot` relative to the robot of P.-G. Kim et al.: the ratio of their radii. It converts lengths
/// of the paper to those of `robot`.
double pioneerScale(const RobotModel& robot);

/// The eight front sonars of P.-G. Kim et al. (2006): bearings of 90, 50, 30, 10, -10, -30, -50 and -90
/// degrees on the body's outline, cones of 12.5 degrees to either side, a range of 1.5 m times the scale.
std::vector<SonarSpec> frontSonars(const RobotModel& robot);

/// Checks ranges; the error names the sonar, counted from 0, and the value.
Result<void> validate(const SonarModel& model);

}  // namespace fulbito
