#pragma once

#include <cstdint>

#include "fulbito/detail/random.hpp"

namespace fulbito {

/// Every consumer of randomness has its own stream, so a new consumer does not shift the others.
/// The numbers are part of the determinism contract: append, never renumber. Number 6 is reserved for tests
/// (tests/support/test_stream.hpp), 17 to 19 and 22 for experiments/papers (its random/streams.hpp).
enum class Stream : std::uint32_t {
  kLayout = 1,  ///< placement of obstacles, starts and goals in a suite
  kObstacleMotion = 2,
  kSensorNoise = 3,
  kTuner = 4,
  kBootstrap = 5,
  kWheelCommands = 7,   ///< random drivers of benchmarks and tests
  kVision = 8,          ///< vision noise, one stream per team (seat)
  kPlacement = 9,       ///< placement errors at a match's restarts
  kSeries = 10,         ///< seeds of a series' pairs
  kRandomTeam = 11,     ///< the team `random`
  kCoinToss = 12,       ///< a referee's coin tosses: first kick-offs, unbroken ties
  kDrill = 13,          ///< starts of drills
  kStartHeading = 14,   ///< start headings in a comparison's trials
  kLibraryTeam = 15,    ///< numbers that a shared library asks its host for
  kSonar = 16,          ///< errors of ultrasonic sensors
  kEncoders = 20,       ///< slip of wheels in their encoders' readings
  kGyro = 21,           ///< noise and drift of a gyro
  kRatings = 23,        ///< resampled pairs of a tournament's ratings
  kStartBook = 24,      ///< choice of the starts of tournaments' matches
  kPerturbation = 25,   ///< directions of the perturbations of a tuning
  kTuneStarts = 26,     ///< seeds of the iterations of a tuning
  kEpisodes = 27,       ///< seeds of an environment's episodes
  kEpisodeStart = 28,   ///< random places at the start of an episode
  kEpisodeModels = 29,  ///< models of robots and ball of an episode
};

}  // namespace fulbito
