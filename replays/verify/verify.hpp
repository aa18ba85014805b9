#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fulbito/recording.hpp"

namespace fulbito {

/// The first difference between a recording and its resimulation.
struct Divergence {
  Tick tick = 0;          ///< first tick of the recording whose hash differs
  std::int64_t play = 0;  ///< number of its play, from 0
  Tick play_tick = 0;     ///< ticks since the play began
  /// The first body that differs, possibly at a later tick: bodies are hashed once per second and sampled 30
  /// times per second.
  std::optional<std::size_t> body;
  std::string body_name;
  int bodies = 0;  ///< number of bodies that differ at `body_tick`
  Tick body_tick = 0;
  std::string field;      ///< x, y or heading if a sample differs; else "place" or "motion"
  double recorded = 0.0;  ///< recorded value of the sample [m] or [rad]
  double replayed = 0.0;
  std::string text;  ///< description in one sentence
};

/// The result of verifying a recording.
struct Verification {
  Tick ticks = 0;
  std::int64_t plays = 0;
  double seconds = 0.0;    ///< simulated time [s]
  bool heard = false;      ///< another program's motion: it cannot be simulated again, so nothing is verified
  bool finished = false;   ///< false: the recording is cut off; its remaining part was verified
  bool same_build = true;  ///< made by the same compiler, build type and libraries as this program
  std::uint64_t final_hash = 0;
  std::optional<Divergence> divergence;  ///< empty: identical, bit for bit

  bool same() const { return !divergence.has_value(); }
};

/// Simulates a recording again and compares every hash in it. Errors: as `resimulate`.
Result<Verification> verify(const RecordingReader& recording);
/// Verifies a file. Errors: also as `RecordingReader::open`.
Result<Verification> verifyRecording(const std::string& file);

}  // namespace fulbito
