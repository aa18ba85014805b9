#include "match/record/recorded_events.hpp"

#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

}  // namespace

TEST_CASE("a recording gives the lines that were written while the match was played", "[unit]") {
  for (const char* yellow : {"chaser", "random"}) {
    const MatchConfig config = shortMatch("chaser", yellow, 60.0);
    std::string live, replayed;
    EventLines lines([&live](std::string_view line) { live += line; });
    const auto reader = RecordingReader::parse(recorded(config, RecordingLevel::kRecipe, &lines), "match");
    REQUIRE(reader);
    REQUIRE(writeEventLines(*reader, [&replayed](std::string_view line) { replayed += line; }));
    CHECK(live == replayed);
    CHECK(live.find("kick-off") != std::string::npos);
  }
}

TEST_CASE("events come in order, each with the score after it", "[unit]") {
  const auto reader =
      RecordingReader::parse(recorded(shortMatch("chaser", "idle", 60.0), RecordingLevel::kRecipe), "match");
  REQUIRE(reader);
  const auto events = eventsOf(*reader);
  REQUIRE(events);
  Tick last = 0;
  int goals = 0;
  for (const ReplayEvent& event : *events) {
    CHECK(event.call.tick >= last);
    last = event.call.tick;
    if (event.call.clause == "goal") ++goals;
    CHECK(event.score[0] + event.score[1] == goals);
  }
  CHECK(goals > 0);
  CHECK(goals == reader->result()->score[0] + reader->result()->score[1]);
  CHECK(events->front().restart == RestartKind::kKickOff);
}

TEST_CASE("a recording whose recipe cannot be understood has no lines", "[unit]") {
  RecordingHeader header = recordingHeader(shortMatch("chaser", "idle", 1.0), RecordingLevel::kRecipe);
  header.recipe.rules = "[rules";
  std::string bytes;
  REQUIRE(RecordingWriter::create(into(bytes), header)->finish({}));
  const auto reader = RecordingReader::parse(bytes, "match");
  REQUIRE(reader);
  const auto written = writeEventLines(*reader, [](std::string_view) {});
  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kBadInput);
}

}  // namespace fulbito
