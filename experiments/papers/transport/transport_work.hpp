#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/carrying.hpp"
#include "experiments/papers/transport/constraint_curve.hpp"
#include "experiments/papers/transport/contour_walk.hpp"
#include "experiments/papers/transport/rod_drive.hpp"
#include "fulbito/report.hpp"

/// The values of the experiment, before they become tables, charts and scenes.
namespace fulbito {

/// The errors of one length of step.
struct StepErrors {
  double step = 0.0;   ///< [s]
  Carrying euler;      ///< the slave runs at the speed of the relation
  Carrying projected;  ///< it ends where the rod fits
};

/// One random path.
struct RandomRun {
  TransportTask task;
  ConstraintCurve curve;  ///< without its points but the last
  ContourEnd contour;     ///< the independent check
  Carrying work;          ///< by both robots, refused or not
  Carrying printed;       ///< by robots whose master never slows down

  bool accepted() const { return curve.arrives(); }
  /// Completed, or refused where the check ends at the same place.
  bool right() const;
};

/// One run by the printed rules: a master that never slows down, without or with projection.
struct PrintedRun {
  double step = 0.0;  ///< [s]
  bool project = false;
  Carrying work;
};

/// One radio.
struct RadioRun {
  std::string name;
  RadioModel radio;
  Carrying work;
};

/// One way to drive the real rod.
struct RealRun {
  std::string name;
  double pace = 0.0;  ///< [m/s] limit of either robot
  RodDrive drive;
};

/// All that is measured on one path.
struct PathWork {
  TransportTask task;
  ConstraintCurve curve;
  Carrying work;  ///< with rows
  std::vector<StepErrors> steps;
  std::vector<RadioRun> radios;
  RodWorld world;
  std::vector<RealRun> real;  ///< empty for a path with corners
  std::string why_not_real;   ///< in that case
};

/// How the robots are set up by the experiment's settings.
struct TransportSettings {
  std::string path;  ///< file; empty: the paper's
  CarryPlan plan;
};

/// What `transportSettings` reads.
std::vector<ExperimentSetting> transportSettingList();
/// Settings of a request. Errors: kUsage naming the setting and its range.
Result<TransportSettings> transportSettings(const ExperimentRequest& request);

/// Runs all of one path. Errors: kBadInput with the reason why the path is refused; kInterrupted.
Result<PathWork> workOn(const TransportTask& task, const TransportSettings& settings,
                        const ExperimentRequest& request);

/// The printed rules on a path, at several steps, without and with projection. Errors: kInterrupted.
Result<std::vector<PrintedRun>> printedRuns(const TransportTask& task, const ExperimentRequest& request);

/// `count` random paths of the request's seed. Errors: kInterrupted.
Result<std::vector<RandomRun>> randomRuns(const ExperimentRequest& request, std::size_t count);

/// References of a plan's rows, one per `tick` [s]: the speeds as commanded, without regard to wheels.
std::vector<RodReference> referencesOf(const TransportTask& task, const Carrying& work, double tick);

}  // namespace fulbito
