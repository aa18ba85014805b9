#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/papers/localization/estimation/ekf_estimator.hpp"
#include "experiments/papers/localization/estimation/threshold_estimator.hpp"
#include "experiments/papers/localization/rover.hpp"

namespace fulbito::localization {

/// How a robot keeps its pose while it drives.
enum class Scheme { kDeadReckoning, kThreshold, kEkf };
inline constexpr std::array kSchemes{Scheme::kDeadReckoning, Scheme::kThreshold, Scheme::kEkf};
constexpr std::string_view nameOf(Scheme scheme) {
  constexpr std::array<std::string_view, 3> kNames{"dead reckoning", "threshold", "ekf"};
  return kNames[static_cast<std::size_t>(scheme)];
}

/// One task: a robot somewhere in a room.
struct CleaningTask {
  FieldGeometry field;    ///< the room's walls
  Rover rover;            ///< with the errors of its sensors
  SensorSpread spread;    ///< as stated to the robot
  Pose2 start;            ///< room frame
  double celsius = 20.0;  ///< of the air
  double warming = 0.0;   ///< [K] of the air when the robot begins to drive, after its first fix
  std::uint64_t seed = 1;
  std::uint64_t index = 0;
};

enum class CleaningOutcome { kFinished, kRefused, kWrongAxis, kHitWall, kTimeOut };
constexpr std::string_view nameOf(CleaningOutcome outcome) {
  constexpr std::array<std::string_view, 5> kNames{"finished", "refused", "wrong axis", "hit a wall",
                                                   "time-out"};
  return kNames[static_cast<std::size_t>(outcome)];
}

/// A moment of a run, at each echo. Poses in the robot's room frame.
struct CleaningMoment {
  double seconds = 0.0;  ///< since the robot was put down
  double way = 0.0;      ///< [m] of the route done so far, by its parts
  std::size_t part = 0;  ///< index of the point of the route at which the present part begins
  Pose2 truth;
  Pose2 estimate;
  double deviation = 0.0;                                   ///< [m] of the truth from the route
  std::array<std::optional<double>, kBeams.size()> ranges;  ///< [m] of the echoes as the robot takes them
};

/// What came of a run. NaN: it did not come so far.
struct CleaningResult {
  CleaningOutcome outcome = CleaningOutcome::kRefused;
  std::string reason;                   ///< of a refusal
  double heading_error = nan();         ///< [rad] after alignment
  double level_centre_error = nan();    ///< [rad] that the middle of near-shortest echoes would have had
  double shortest_echo_error = nan();   ///< [rad] that the shortest echo would have had
  double echo_speed = nan();            ///< [m/s] the calibrated constant
  double echo_speed_error = nan();      ///< relative, of the calibrated constant
  double start_error = nan();           ///< [m] of the first pose
  double max_deviation = nan();         ///< [m] of the true path from the route
  double rms_deviation = nan();         ///< [m]
  double max_heading_error = nan();     ///< [rad] of the estimate while driving
  double final_error = nan();           ///< [m] of the estimate at the end
  double squared_error = nan();         ///< NEES at the end, of the filter only
  double route_length = nan();          ///< [m]
  double seconds = nan();               ///< of the whole run
  std::vector<Vec2> route;              ///< [m] room frame; only with moments
  std::vector<CleaningMoment> moments;  ///< only if asked for
  bool turned_frame = false;            ///< the robot's origin is the opposite corner

  /// Whether it came home and was never farther than `limit` [m] from its route.
  bool inside(double limit) const { return outcome == CleaningOutcome::kFinished && max_deviation <= limit; }

 private:
  static constexpr double nan() { return std::numeric_limits<double>::quiet_NaN(); }
};

/// Aligns, locates, drives the whole route. Errors: as World::create.
Result<CleaningResult> runCleaning(const CleaningTask& task, Scheme scheme, bool with_moments = false);

}  // namespace fulbito::localization
