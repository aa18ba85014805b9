#pragma once

#include <array>

#include "experiments/capture/curve_drive.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::capture {

/// One trajectory at one speed, driven in three ways.
struct CurveRow {
  CurveDriveResult ideal;    ///< from rest, a robot without slip: Table 4
  CurveDriveResult driven;   ///< at speed from the first metre: Tables 5 and 6
  CurveDriveResult started;  ///< from rest

  /// [s] of `driven` with the time that speeding up costs, v / 2a.
  double time(double speed) const;
};

/// Both trajectories at the paper's five speeds.
struct CurveTable {
  std::array<CurveRow, 5> single;
  std::array<CurveRow, 5> both;  ///< the double curvature
};

/// Drives all of them. Errors: of the world; kInterrupted.
Result<CurveTable> driveCurves(const RobotModel& robot, int jobs, const Progress& progress);

}  // namespace fulbito::capture
