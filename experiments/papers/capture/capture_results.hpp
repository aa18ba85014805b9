#pragma once

#include <string>
#include <vector>

#include "experiments/papers/capture/curve_table.hpp"
#include "experiments/papers/capture/estimator_study.hpp"
#include "experiments/papers/capture/pursuit.hpp"
#include "experiments/papers/capture/random_captures.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {

/// Settings of the experiment.
struct CaptureSettings {
  double gap = 0.24;  ///< [m]
  SightingNoise noise;
  int captures = 100;
};

/// One variant of driving the capture of Fig. 18.
struct Fig18Run {
  std::string way;  ///< name in the table
  PursuitSetup setup;
  PursuitResult result;  ///< always has a plan
};

/// Indices of `CaptureResults::runs`.
enum Fig18Way : std::size_t {
  kIdeal = 0,      ///< a robot without slip; the wheels turn as planned
  kAsPlanned = 1,  ///< the wheels turn as planned
  kPerfect = 2,    ///< tracked, with a camera without noise
  kTracked = 3,    ///< tracked
  kFree = 4,       ///< tracked, with both bodies in one world; `gap` is the free space between them
};

/// All results for the report.
struct CaptureResults {
  CaptureSettings settings;
  std::uint64_t seed = 1;
  RobotModel robot;
  CurveTable curves;
  std::vector<CurveError> curve_errors;
  std::vector<EstimatorRow> estimators;
  std::vector<Fig18Run> runs;        ///< by Fig18Way
  std::vector<PursuitResult> again;  ///< kTracked with other errors of the sightings; each has a plan
  RandomCaptures random;
};

/// @{ Parts of the report.
void addFigures(const CaptureResults& results, ExperimentReport& report);
void addTables(const CaptureResults& results, ExperimentReport& report);
/// tables that compare the paper with itself
void addChecks(const CaptureResults& results, ExperimentReport& report);
void addCharts(const CaptureResults& results, ExperimentReport& report);
void addScenes(const CaptureResults& results, ExperimentReport& report);
/// @}

}  // namespace fulbito::capture
