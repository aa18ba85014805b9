#pragma once

#include <array>
#include <cstdint>

#include "fulbito/detail/vec2.hpp"

namespace fulbito {

/// Every consumer of randomness has its own stream, so a new consumer does not shift the others.
/// The numbers are part of the determinism contract: append, never renumber. Number 6 is reserved for tests
/// (tests/support/test_stream.hpp).
enum class Stream : std::uint32_t {
  kLayout = 1,  ///< placement of obstacles, starts and goals in a suite
  kObstacleMotion = 2,
  kSensorNoise = 3,
  kTuner = 4,
  kBootstrap = 5,
  kWheelCommands = 7,  ///< random drivers of benchmarks and tests
  kVision = 8,         ///< vision noise, one stream per team (seat)
  kPlacement = 9,      ///< placement errors at a match's restarts
  kSeries = 10,        ///< seeds of a series' pairs
  kRandomTeam = 11,    ///< the team `random`
  kCoinToss = 12,      ///< a referee's coin tosses: first kick-offs, unbroken ties
  kDrill = 13,         ///< starts of drills
  kStartHeading = 14,  ///< start headings in a comparison's trials
  kLibraryTeam = 15,   ///< what a shared library draws from its host
  kSonar = 16,         ///< errors of ultrasonic sensors
  kCaptureTask = 17,   ///< starts of captures (experiment `capture`)
  kSighting = 18,      ///< noise of its camera
  kTransport = 19,     ///< random paths, and messages that get lost, where two robots carry a rod
  kEncoders = 20,      ///< slip of wheels as their encoders see it
  kGyro = 21,          ///< noise and drift of a gyro
  kRoom = 22,          ///< rooms, poses and sensors of the experiment `localization`
  kRatings = 23,       ///< resampled pairs of a tournament's ratings
  kStartBook = 24,     ///< starts of tournaments' matches
  kPerturbation = 25,  ///< directions of the perturbations of a tuning
  kTuneStarts = 26,    ///< seeds of the iterations of a tuning
};

/// Counter-based random numbers (Philox4x32-10, Salmon et al., SC 2011): the n-th draw is a pure function of
/// (seed, stream, index, n). Distributions are the project's own, since the standard ones differ between
/// implementations. A stream repeats after 2^34 32-bit words.
class Rng {
 public:
  /// @param index  separates consumers of one stream, e.g. the number of a trial
  Rng(std::uint64_t seed, Stream stream, std::uint64_t index = 0);

  std::uint32_t bits32();
  std::uint64_t bits64();
  /// In [0, 1), 53 bits.
  double uniform();
  /// In [low, high), where high - low does not overflow; `low` when the interval is empty.
  double uniform(double low, double high);
  /// In [0, n), without bias; 0 when n <= 1.
  std::uint32_t below(std::uint32_t n);
  /// Standard normal (Marsaglia's polar method on the project's own log).
  double normal();
  double normal(double mean, double sigma) { return mean + sigma * normal(); }

 private:
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t index_;
  std::uint32_t block_ = 0;
  std::uint32_t used_ = 4;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace fulbito
