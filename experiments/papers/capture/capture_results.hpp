#pragma once

#include <string>
#include <vector>

#include "experiments/papers/capture/curve_table.hpp"
#include "experiments/papers/capture/estimator_study.hpp"
#include "experiments/papers/capture/pursuit.hpp"
#include "experiments/papers/capture/random_captures.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {

/// What the experiment is asked for.
struct CaptureSettings {
  double gap = 0.24;  ///< [m]
  SightingNoise noise;
  int captures = 100;
};

/// One way of driving the capture of Fig. 18.
struct Fig18Run {
  std::string way;  ///< for the table
  PursuitSetup setup;
  PursuitResult result;  ///< of a plan, always
};

/// Ways of `CaptureResults::runs`.
enum Fig18Way : std::size_t {
  kIdeal = 0,      ///< a robot without slip, wheels as planned
  kAsPlanned = 1,  ///< wheels as planned
  kPerfect = 2,    ///< tracked, a camera without noise
  kTracked = 3,    ///< tracked
  kFree = 4,       ///< tracked, both bodies in one world, the gap free between them
};

/// Everything that the report shows.
struct CaptureResults {
  CaptureSettings settings;
  std::uint64_t seed = 1;
  RobotModel robot;
  CurveTable curves;
  std::vector<CurveError> curve_errors;
  std::vector<EstimatorRow> estimators;
  std::vector<Fig18Run> runs;        ///< by Fig18Way
  std::vector<PursuitResult> again;  ///< kTracked with other errors of the sightings; all have a plan
  RandomCaptures random;
};

/// @{ Parts of the report.
void addFigures(const CaptureResults& results, ExperimentReport& report);
void addTables(const CaptureResults& results, ExperimentReport& report);
void addChecks(const CaptureResults& results, ExperimentReport& report);  ///< tables: paper against itself
void addCharts(const CaptureResults& results, ExperimentReport& report);
void addScenes(const CaptureResults& results, ExperimentReport& report);
/// @}

}  // namespace fulbito::capture
