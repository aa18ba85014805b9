#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/capture/capture_plan.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {

/// How a robot follows a plan.
enum class PursuitDrive : std::uint8_t {
  kOpen,  ///< the wheels turn as planned, without feedback
  /// feedback corrects speed and yaw rate toward the plan, and the wheel speeds allow for the known slip
  kTracked,
};

/// A capture in the world.
struct PursuitSetup {
  RobotModel robot;
  Pose2 start;
  ObjectMotion object;  ///< true motion, which the robot knows only by sightings
  double gap = 0.24;    ///< [m] wanted gap between the centres
  CaptureLimits limits;
  SightingNoise noise;
  PursuitDrive drive = PursuitDrive::kTracked;
  bool together = false;    ///< both bodies are in one world and can touch; else each in its own
  std::uint64_t seed = 1;   ///< @{ seed and index of the sightings' errors
  std::uint64_t index = 0;  ///< @}
};

/// Results of a pursuit.
struct PursuitResult {
  CaptureAnswer answer;                 ///< first plan; if it is empty, the rest is empty too
  CapturePlan driven;                   ///< the plan with its last correction
  double time = 0.0;                    ///< [s] duration of the capture
  double gap = 0.0;                     ///< [m] between the centres at that time, along the object's path
  double aside = 0.0;                   ///< [m] from the object's line to the robot, positive to the left
  double speed = 0.0;                   ///< [m/s] of the robot, forward
  double heading = 0.0;                 ///< [rad] of the robot
  double largest_rim = 0.0;             ///< [m/s] fastest command of a wheel
  double worst_off = 0.0;               ///< [m] largest distance from the plan
  bool touched = false;                 ///< whether the bodies touched
  std::vector<Pose2> robot, object;     ///< poses per tick
  std::vector<ObjectMotion> estimates;  ///< one per sighting since the start
};

/// Watches the object for 6.5 s, plans and drives. The camera sees the object ten times per second all the
/// time. As soon as the robot drives straight, it plans the line and the last curve again with the estimate
/// at that time; then the plan shifts with the estimate. Errors: of the world.
Result<PursuitResult> pursue(const PursuitSetup& setup);

}  // namespace fulbito::capture
