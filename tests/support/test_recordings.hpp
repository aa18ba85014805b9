#pragma once

#include <functional>
#include <string>

#include "fulbito/recorder.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito::test {

/// A sink that appends to a string.
inline RecordingWriter::Sink into(std::string& bytes) {
  return [&bytes](std::string_view more) -> Result<void> {
    bytes.append(more);
    return {};
  };
}

/// Plays a match and gives its recording.
inline std::string recorded(const MatchConfig& config, RecordingLevel level = RecordingLevel::kFull,
                            MatchObserver* witness = nullptr) {
  std::string bytes;
  auto match = Match::create(config);
  REQUIRE(match);
  auto recorder = MatchRecorder::create(into(bytes), config, level);
  REQUIRE(recorder);
  match->watch(*recorder);
  if (witness != nullptr) match->watch(*witness);
  while (match->step()) {
  }
  REQUIRE(recorder->written());
  return bytes;
}

inline RecordingReader readerOf(std::string bytes) {
  auto reader = RecordingReader::parse(std::move(bytes), "game.fbr");
  REQUIRE(reader);
  return std::move(*reader);
}

}  // namespace fulbito::test
