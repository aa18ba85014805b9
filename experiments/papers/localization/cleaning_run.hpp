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

/// How a robot estimates its pose while it drives.
enum class Scheme { kDeadReckoning, kThreshold, kEkf };
inline constexpr std::array kSchemes{Scheme::kDeadReckoning, Scheme::kThreshold, Scheme::kEkf};
constexpr std::string_view nameOf(Scheme scheme) {
  constexpr std::array<std::string_view, 3> kNames{"dead reckoning", "threshold", "ekf"};
  return kNames[static_cast<std::size_t>(scheme)];
}

/// One task: a robot at some pose in a room.
struct CleaningTask {
  FieldGeometry field;    ///< the room's walls
  Rover rover;            ///< with the errors of its sensors
  SensorSpread spread;    ///< the sensors' errors as the robot knows them
  Pose2 start;            ///< room frame
  double celsius = 20.0;  ///< air temperature
  double warming = 0.0;   ///< [K] of the air after the first fix, when the drive begins
  std::uint64_t seed = 1;
  std::uint64_t index = 0;
};

enum class CleaningOutcome { kFinished, kRefused, kWrongAxis, kHitWall, kTimeOut };
constexpr std::string_view nameOf(CleaningOutcome outcome) {
  constexpr std::array<std::string_view, 5> kNames{"finished", "refused", "wrong axis", "hit a wall",
                                                   "time-out"};
  return kNames[static_cast<std::size_t>(outcome)];
}

/// The state of a run at one echo. Poses are in the robot's room frame.
struct CleaningMoment {
  double seconds = 0.0;  ///< since the robot was put down
  double way = 0.0;      ///< [m] completed length of the route
  std::size_t part = 0;  ///< index of the point of the route at which the present part begins
  Pose2 truth;
  Pose2 estimate;
  double deviation = 0.0;                                   ///< [m] from the route to the true position
  std::array<std::optional<double>, kBeams.size()> ranges;  ///< [m] of the echoes, with the robot's constant
};

/// Results of a run. NaN: the run did not get that far.
struct CleaningResult {
  CleaningOutcome outcome = CleaningOutcome::kRefused;
  std::string reason;                   ///< reason of a refusal
  double heading_error = nan();         ///< [rad] after the alignment
  double level_centre_error = nan();    ///< [rad] by the middle of the near-shortest echoes instead
  double shortest_echo_error = nan();   ///< [rad] by the shortest echo instead
  double echo_speed = nan();            ///< [m/s] the calibrated constant
  double echo_speed_error = nan();      ///< relative error of the calibrated constant
  double start_error = nan();           ///< [m] error of the first pose
  double max_deviation = nan();         ///< [m] greatest distance of the true path from the route
  double rms_deviation = nan();         ///< [m]
  double max_heading_error = nan();     ///< [rad] greatest error of the estimate during the drive
  double final_error = nan();           ///< [m] error of the estimate at the end
  double squared_error = nan();         ///< NEES at the end; only for the filter
  double route_length = nan();          ///< [m]
  double seconds = nan();               ///< duration of the whole run
  std::vector<Vec2> route;              ///< [m] room frame; only with moments
  std::vector<CleaningMoment> moments;  ///< only if requested
  bool turned_frame = false;            ///< the robot's origin is the opposite corner

  /// Whether the robot came home and was never farther than `limit` [m] from its route.
  bool inside(double limit) const { return outcome == CleaningOutcome::kFinished && max_deviation <= limit; }

 private:
  static constexpr double nan() { return std::numeric_limits<double>::quiet_NaN(); }
};

/// Aligns and locates the robot and drives the whole route. Errors: as World::create.
Result<CleaningResult> runCleaning(const CleaningTask& task, Scheme scheme, bool with_moments = false);

}  // namespace fulbito::localization
