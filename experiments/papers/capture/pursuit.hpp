#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/capture/capture_plan.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {

/// How a robot follows a plan.
enum class PursuitDrive : std::uint8_t {
  kOpen,     ///< the wheels turn as planned, whatever comes of it
  kTracked,  ///< speed and yaw rate are corrected toward the plan, and the wheels allow for the known slip
};

/// A capture in the world.
struct PursuitSetup {
  RobotModel robot;
  Pose2 start;
  ObjectMotion object;  ///< at time 0; the truth, of which the robot has sightings only
  double gap = 0.24;    ///< [m] wanted, between the middles
  CaptureLimits limits;
  SightingNoise noise;
  PursuitDrive drive = PursuitDrive::kTracked;
  bool together = false;    ///< both bodies are in one world and can touch; false: each in its own
  std::uint64_t seed = 1;   ///< @{ of the sightings
  std::uint64_t index = 0;  ///< @}
};

/// What the robot did.
struct PursuitResult {
  CaptureAnswer answer;                 ///< of the first plan; without one the rest is empty
  CapturePlan driven;                   ///< the plan with its last correction
  double time = 0.0;                    ///< [s] of the capture
  double gap = 0.0;                     ///< [m] of the middles at that time, along the object's way
  double aside = 0.0;                   ///< [m] of the robot from the object's line, positive to its left
  double speed = 0.0;                   ///< [m/s] of the robot, forward
  double heading = 0.0;                 ///< [rad] of the robot
  double largest_rim = 0.0;             ///< [m/s] fastest command of a wheel
  double worst_off = 0.0;               ///< [m] largest distance from the plan
  bool touched = false;                 ///< the bodies touched
  std::vector<Pose2> robot, object;     ///< poses per tick
  std::vector<ObjectMotion> estimates;  ///< per sighting since the start
};

/// Watches the object for 6.5 s, plans, drives. The object is seen ten times a second all the time. Once the
/// robot drives straight, line and last curve are planned again with what is known by then; after that the
/// plan shifts with the estimate. Errors: of the world.
Result<PursuitResult> pursue(const PursuitSetup& setup);

}  // namespace fulbito::capture
