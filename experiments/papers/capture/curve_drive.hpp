#pragma once

#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// One drive of Tables 5 and 6 of Choi & Lee (2005).
struct CurveDriveSetup {
  RobotModel robot;
  double speed = 0.1;           ///< [m/s]
  double radius = 3.75;         ///< [m] for which the wheels are set
  double turn = 1.913718;       ///< [rad] of each curve without slip
  bool twice = false;           ///< a second curve to the other side follows
  bool from_rest = false;       ///< speeds up at `acceleration` first; false: starts at speed
  double acceleration = 0.05;   ///< [m/s^2] of the body from rest, and of each wheel between the curves
  bool instant_change = false;  ///< the wheels change over between the curves within a tick
};

/// What it came to.
struct CurveDriveResult {
  double radius1 = 0.0;      ///< [m] circle fitted to the first curve's part at full speed
  double radius2 = 0.0;      ///< [m] the same of the second curve; 0 without one
  double time = 0.0;         ///< [s] driven
  double distance = 0.0;     ///< [m] driven
  double end_error = 0.0;    ///< [m] from the end without slip
  std::vector<Pose2> trace;  ///< one pose per tick, from the start
};

/// The end of the curves without slip, for a start at the origin with a heading of 90 degrees.
Vec2 idealEnd(const CurveDriveSetup& setup);

/// Drives it in a world of its own, from the origin with a heading of 90 degrees, to the right first. The
/// first curve ends on the ray from its centre without slip through its end without slip. Then the wheels
/// change over, and the second one ends where the heading is 90 degrees again. Errors: of the world; kUsage
/// for a drive that does not end within 200 s.
Result<CurveDriveResult> driveCurve(const CurveDriveSetup& setup);

}  // namespace fulbito::capture
