#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/config/presets.hpp"
#include "engine/core/models/sensor_model.hpp"
#include "navigation/registry.hpp"
#include "referee/trial/trial_referee.hpp"

namespace fulbito {

/// A monotonic clock [ns]. Libraries read no clock themselves: the program passes one in. Measured times only
/// go into fields named compute_ or wall_.
using Clock = std::function<std::int64_t()>;

/// One trial: a robot, a layout, a navigator.
struct TrialConfig {
  Layout layout;
  FieldGeometry field;
  RobotPreset robot;  ///< its max_wheel_speed is the speed limit of the trial
  PhysicsProfile physics;
  NavigatorChoice navigator;
  SensorModel
      sensors;  ///< of the observation; the navigator knows the commands given since, and rolls it forward
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;
  double limit_clearance = 0.058;  ///< [m] between the robot's centre and obstacles along the L* path
  std::uint64_t seed = 1;
  std::uint64_t index = 0;  ///< number of the trial in its suite, for its random streams
};

/// One control tick of a trial.
struct TraceRow {
  double time = 0.0;  ///< [s]
  RobotState robot;
  WheelSpeeds command;
};

/// The start of a contact with an obstacle or wall.
struct Touch {
  double time = 0.0;  ///< [s]
  Vec2 point;         ///< [m] of contact
};

/// The result of a trial.
struct TrialResult {
  TrialScore score;
  std::vector<TraceRow> trace;     ///< from the start, one row per tick
  std::vector<Touch> touches;      ///< in chronological order
  std::vector<Vec2> limit_path;    ///< the L* path
  std::vector<double> compute_us;  ///< navigator and follower per tick; empty without a clock
  std::uint64_t final_hash = 0;    ///< of all states of the trial
};

class TrialRecorder;

/// Runs a trial and records it if a recorder is given. Errors: kUsage or kBadInput if the layout does not fit
/// the field or robot; those of the recorder.
Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock,
                             TrialRecorder* recorder = nullptr);

/// Appends an obstacle as discs for navigators. A box is divided along its longer side into squares, with one
/// disc per square.
void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs);

}  // namespace fulbito
