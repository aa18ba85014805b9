#pragma once

#include <array>
#include <vector>

#include "experiments/papers/capture/curve_drive.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::capture {

/// One trajectory at one speed, driven in several ways.
struct CurveRow {
  CurveDriveResult ideal;    ///< from rest, a robot without slip: Table 4
  CurveDriveResult driven;   ///< at speed from the first metre: Tables 5 and 6
  CurveDriveResult started;  ///< from rest
  CurveDriveResult instant;  ///< as `driven`, but the wheels change over at once; the double curvature only

  /// [s] of `driven` with the time that speeding up costs, v / 2a.
  double time(double speed) const;
};

/// Both trajectories at the paper's five speeds.
struct CurveTable {
  std::array<CurveRow, 5> single;
  std::array<CurveRow, 5> both;  ///< the double curvature
};

/// [s] of a drive at speed from the first metre, with the time that speeding up costs, v / 2a.
double timeOf(const CurveDriveResult& drive, double speed);

/// Drives all of them. Errors: of the world; kInterrupted.
Result<CurveTable> driveCurves(const RobotModel& robot, int jobs, const Progress& progress);

/// The error of a curve at one speed: Choi & Lee (2005), Fig. 7.
struct CurveError {
  double radius = 0.0;  ///< [m] for which the wheels are set
  double speed = 0.0;   ///< [m/s]
  double error = 0.0;   ///< [m] from where a robot without slip is after the same way
};

/// [m] that each curve of `driveCurveErrors` is driven.
inline constexpr double kErrorWay = 2.5;

/// Four radii at the paper's five speeds, each driven in the world over `kErrorWay`. Errors: of the world.
Result<std::vector<CurveError>> driveCurveErrors(const RobotModel& robot);

}  // namespace fulbito::capture
