#pragma once

#include "apps/league/heard_events.hpp"
#include "apps/league/heard_recorder.hpp"
#include "tests/support/test_recordings.hpp"

/// Frames of a server, and a recorder of them in memory.
namespace fulbito::test {

using namespace fulbito::app;

constexpr std::uint64_t kServer = 1;

/// A frame in which all that moves has other coordinates in each step.
inline wire::Vision visionAt(std::uint32_t step) {
  const double s = step * 1e-3;
  wire::Vision vision;
  vision.step = step;
  vision.ball.position = {0.1 + 0.3 * s, -0.2};
  vision.field.length = 1.5;
  vision.field.width = 1.3;
  for (const TeamId team : kTeams) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      wire::SeenRobot robot{i, {}};
      robot.state.pose = {{(team == TeamId::kBlue ? -0.2 : 0.2) * (i + 1) + 0.01 * s, 0.1 * i + 0.1 * s},
                          0.3 * i + s / 7};
      vision.robots[indexOf(team)].push_back(robot);
    }
  }
  return vision;
}

inline wire::RefereeCommand command(wire::Foul foul, wire::Half half = wire::Half::kFirst) {
  wire::RefereeCommand command;
  command.foul = foul;
  command.half = half;
  return command;
}

/// A recorder and what it has written.
struct HeardMatch {
  std::string bytes;
  HeardRecorder recorder;
  int opened = 0;

  HeardMatch()
      : recorder(shortMatch("idle", "idle", 10.0), [this](const RecordingHeader& header) {
          ++opened;
          return RecordingWriter::create(into(bytes), header);
        }) {}
  HeardMatch(const HeardMatch&) = delete;

  bool see(const wire::Vision& vision, std::uint64_t sender = kServer, double now = 0.0) {
    const auto seen = recorder.see(vision, sender, now);
    REQUIRE(seen);
    return *seen;
  }
  void see(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t step = first; step <= last; step += 16) REQUIRE(see(visionAt(step)));
  }
  RecordingReader finish() {
    REQUIRE(recorder.finish());
    return readerOf(bytes);
  }
};

inline ReplayTimeline timelineOf(const RecordingReader& reader) {
  auto timeline = ReplayTimeline::read(reader);
  REQUIRE(timeline);
  return std::move(*timeline);
}

inline std::vector<std::string> clausesOf(const ReplayTimeline& timeline) {
  std::vector<std::string> clauses;
  for (const RecordedEvent& event : timeline.events()) clauses.push_back(event.clause);
  return clauses;
}

}  // namespace fulbito::test
