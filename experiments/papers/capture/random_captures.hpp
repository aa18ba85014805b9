#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/papers/capture/pursuit.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::capture {

/// A task of the random captures and its result.
struct RandomCapture {
  std::uint64_t index = 0;  ///< index of the draw
  PursuitSetup setup;
  CapturePlan plan;            ///< first plan, without its motion
  double time = 0.0;           ///< [s]
  double gap_error = 0.0;      ///< [m]
  double aside = 0.0;          ///< [m]
  double speed_error = 0.0;    ///< [m/s]
  double heading_error = 0.0;  ///< [rad]
  double largest_rim = 0.0;    ///< [m/s]
  bool touched = false;
  /// Whether gap, place, speed and heading are within the tolerances and nothing touched.
  bool caught() const;
};

/// @{ Tolerances of a capture, equal to half the bands for Fig. 18.
inline constexpr double kGapTolerance = 0.09;                  // [m]
inline constexpr double kAsideTolerance = 0.05;                // [m]
inline constexpr double kSpeedTolerance = 0.01;                // [m/s]
inline constexpr double kHeadingTolerance = 2 * 0.0174532925;  // [rad]
/// @}

/// Captures, and the number of draws that the planner refused.
struct RandomCaptures {
  std::vector<RandomCapture> captures;
  std::array<int, 6> refused{};  ///< number of draws per CaptureRefusal
};

/// The task of a draw: the robot at the origin with a random heading; the object 1.5 to 4 m away in a random
/// direction, with a random heading, at 0.15 to 0.40 m/s.
PursuitSetup randomTask(const RobotModel& robot, double free_gap, const SightingNoise& noise,
                        std::uint64_t seed, std::uint64_t index);

/// Draws tasks until `count` of them have a plan, and drives these with both bodies in one world. At most 40
/// draws per capture. Errors: of the world; kInterrupted.
Result<RandomCaptures> captureAtRandom(const RobotModel& robot, double free_gap, const SightingNoise& noise,
                                       std::uint64_t seed, int count, int jobs, const Progress& progress);

/// Drives the same capture `count` times, each time with other errors of the sightings: `setup.index` and the
/// numbers after it. Errors: of the world; kInterrupted.
Result<std::vector<PursuitResult>> captureAgain(const PursuitSetup& setup, std::size_t count, int jobs,
                                                const Progress& progress);

}  // namespace fulbito::capture
