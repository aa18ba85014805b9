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

/// Reads a monotonic clock [ns]. Libraries read no clock of their own: the program hands one in, and measured
/// times go only into the fields named compute_ or wall_.
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

/// Where and when the robot began to touch an obstacle or a wall.
struct Touch {
  double time = 0.0;  ///< [s]
  Vec2 point;         ///< [m] of contact
};

/// What came of it.
struct TrialResult {
  TrialScore score;
  std::vector<TraceRow> trace;     ///< from the start, one row a tick
  std::vector<Touch> touches;      ///< in the order in which they began
  std::vector<Vec2> limit_path;    ///< the L* path
  std::vector<double> compute_us;  ///< navigator and follower, each tick; empty without a clock
  std::uint64_t final_hash = 0;    ///< of all states of the trial
};

class TrialRecorder;

/// Runs it, and records it where a recorder is given. Errors: kUsage or kBadInput when the layout does not
/// fit the field or robot; the recorder's.
Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock,
                             TrialRecorder* recorder = nullptr);

/// Obstacles as discs for navigators: boxes are covered by one disc a square, side by side along the longer
/// side.
void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs);

}  // namespace fulbito
