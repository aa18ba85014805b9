#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/carrying.hpp"
#include "experiments/papers/transport/constraint_curve.hpp"
#include "experiments/papers/transport/contour_walk.hpp"
#include "experiments/papers/transport/rod_drive.hpp"
#include "fulbito/report.hpp"

/// The values of the experiment, from which tables, charts and scenes are made.
namespace fulbito {

/// The errors at one length of step.
struct StepErrors {
  double step = 0.0;   ///< [s]
  Carrying euler;      ///< the slave runs at the speed of the speed relation
  Carrying projected;  ///< the slave ends where the rod fits
};

/// One random path.
struct RandomRun {
  TransportTask task;
  ConstraintCurve curve;  ///< only its last point
  ContourEnd contour;     ///< independent check of the curve
  Carrying work;          ///< simulation of both robots, even if the curve is refused
  Carrying printed;       ///< simulation with a master that never slows down

  bool accepted() const { return curve.arrives(); }
  /// Whether the task was completed, or was refused and the check ends at the same place.
  bool right() const;
};

/// One run by the printed rules, with a master that never slows down, without or with projection.
struct PrintedRun {
  double step = 0.0;  ///< [s]
  bool project = false;
  Carrying work;
};

/// The results with one radio.
struct RadioRun {
  std::string name;
  RadioModel radio;
  Carrying work;
};

/// One variant of driving the real rod.
struct RealRun {
  std::string name;
  double pace = 0.0;  ///< [m/s] speed limit of each robot
  RodDrive drive;
};

/// All measurements on one path.
struct PathWork {
  TransportTask task;
  ConstraintCurve curve;
  Carrying work;  ///< with stored rows
  std::vector<StepErrors> steps;
  std::vector<RadioRun> radios;
  RodWorld world;
  std::vector<RealRun> real;  ///< empty for a path with corners
  std::string why_not_real;   ///< the reason, if `real` is empty
};

/// Settings of the experiment.
struct TransportSettings {
  std::string path;  ///< path file; empty: the paper's path
  CarryPlan plan;
};

/// The list of settings that `transportSettings` reads.
std::vector<ExperimentSetting> transportSettingList();
/// The settings of a request. Errors: kUsage naming the setting and its range.
Result<TransportSettings> transportSettings(const ExperimentRequest& request);

/// Runs everything on one path. Errors: kBadInput with the reason if the path is refused; kInterrupted.
Result<PathWork> workOn(const TransportTask& task, const TransportSettings& settings,
                        const ExperimentRequest& request);

/// Runs the printed rules on a path with several step lengths, without and with projection. Errors:
/// kInterrupted.
Result<std::vector<PrintedRun>> printedRuns(const TransportTask& task, const ExperimentRequest& request);

/// Runs `count` random paths of the request's seed. Errors: kInterrupted.
Result<std::vector<RandomRun>> randomRuns(const ExperimentRequest& request, std::size_t count);

/// References from a simulation's rows, one per `tick` [s]: the commanded speeds, without the limits of
/// wheels.
std::vector<RodReference> referencesOf(const TransportTask& task, const Carrying& work, double tick);

}  // namespace fulbito
