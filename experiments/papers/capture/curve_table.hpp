#pragma once

#include <array>
#include <vector>

#include "experiments/papers/capture/curve_drive.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::capture {

/// One trajectory at one speed, driven in several variants.
struct CurveRow {
  CurveDriveResult ideal;    ///< from rest, a robot without slip: Table 4
  CurveDriveResult driven;   ///< at full speed from the start: Tables 5 and 6
  CurveDriveResult started;  ///< from rest
  CurveDriveResult instant;  ///< as `driven`, with an instant change; only for the double curvature

  /// [s] of `driven` plus v / 2a, which is the time that acceleration would cost.
  double time(double speed) const;
};

/// Both trajectories at the paper's five speeds.
struct CurveTable {
  std::array<CurveRow, 5> single;
  std::array<CurveRow, 5> both;  ///< the double curvature
};

/// [s] of a drive at full speed from the start, plus v / 2a, which is the time that acceleration would cost.
double timeOf(const CurveDriveResult& drive, double speed);

/// Drives all rows. Errors: of the world; kInterrupted.
Result<CurveTable> driveCurves(const RobotModel& robot, int jobs, const Progress& progress);

/// The error of a curve at one speed: Choi & Lee (2005), Fig. 7.
struct CurveError {
  double radius = 0.0;  ///< [m] radius for which the wheels are set
  double speed = 0.0;   ///< [m/s]
  double error = 0.0;   ///< [m] from the place of a robot without slip after the same distance
};

/// [m] length of each curve of `driveCurveErrors`.
inline constexpr double kErrorWay = 2.5;

/// Four radii at the paper's five speeds, each driven in the world over `kErrorWay`. Errors: of the world.
Result<std::vector<CurveError>> driveCurveErrors(const RobotModel& robot);

}  // namespace fulbito::capture
