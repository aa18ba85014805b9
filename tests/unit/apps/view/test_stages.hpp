#pragma once

#include <memory>
#include <string>

#include "apps/view/replay_stage.hpp"
#include "fulbito/match.hpp"
#include "fulbito/recorder.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito::test {

/// The timeline of a recording in memory.
inline ReplayTimeline timelineOf(const std::string& bytes) {
  const auto reader = RecordingReader::parse(bytes, "test");
  REQUIRE(reader);
  auto timeline = ReplayTimeline::read(*reader);
  REQUIRE(timeline);
  return std::move(*timeline);
}

inline std::unique_ptr<ReplayStage> replayStage(const std::string& bytes,
                                                const std::string& name = "test.fbr") {
  auto stage = ReplayStage::create(timelineOf(bytes), name);
  REQUIRE(stage);
  return std::move(*stage);
}

}  // namespace fulbito::test
