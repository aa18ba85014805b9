#pragma once

#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::capture {

/// One drive of Tables 5 and 6 of Choi & Lee (2005).
struct CurveDriveSetup {
  RobotModel robot;
  double speed = 0.1;           ///< [m/s]
  double radius = 3.75;         ///< [m] radius for which the wheels are set
  double turn = 1.913718;       ///< [rad] of each curve without slip
  bool twice = false;           ///< whether a second curve to the other side follows
  bool from_rest = false;       ///< accelerates from rest; otherwise starts at full speed
  double acceleration = 0.05;   ///< [m/s^2] of the body from rest, and of each wheel between the curves
  bool instant_change = false;  ///< whether the wheels change between the curves within one tick
};

/// Results of a drive.
struct CurveDriveResult {
  double radius1 = 0.0;      ///< [m] circle fitted to the part of the first curve at full speed
  double radius2 = 0.0;      ///< [m] the same for the second curve; 0 without one
  double time = 0.0;         ///< [s] driven
  double distance = 0.0;     ///< [m] driven
  double end_error = 0.0;    ///< [m] from the end of a drive without slip
  std::vector<Pose2> trace;  ///< one pose per tick, from the start
};

/// The end of the curves without slip, for a start at the origin with a heading of 90 degrees.
Vec2 idealEnd(const CurveDriveSetup& setup);

/// Drives `setup` in its own world, from the origin with a heading of 90 degrees and first to the right. The
/// first curve ends on the ray from the centre of the curve without slip through the end of that curve. Then
/// the wheels change, and the second curve ends where the heading is 90 degrees again. Errors: of the world;
/// kUsage for a drive that does not end within 200 s.
Result<CurveDriveResult> driveCurve(const CurveDriveSetup& setup);

}  // namespace fulbito::capture
