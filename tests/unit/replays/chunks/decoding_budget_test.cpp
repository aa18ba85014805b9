#include "replays/chunks/decoding_budget.hpp"

#include "replays/recording_salvage.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

/// A recording with `count` equal events or drawings in its only tick.
std::string withMany(int count, bool drawings) {
  test::Told told;
  told.header = test::sampleHeader();
  {
    test::Teller teller(told);
    teller.tell(1, false);
    RecordedEvent event;
    event.tick = 1;
    event.clause = "goal";
    RecordedDrawing drawing;
    drawing.tick = 1;
    for (int i = 0; i < count; ++i) {
      drawings ? teller.writer().add(drawing) : teller.writer().add(event);
    }
    REQUIRE(teller.finish(1));
  }
  return told.bytes;
}

}  // namespace

TEST_CASE("a small file may not unpack to a large recording", "[unit]") {
  CHECK(RecordingReader::parse(withMany(2000, false), "some.fbr"));
  const std::string bomb = withMany(500000, false);
  CHECK(bomb.size() < 20000);
  const auto refused = RecordingReader::parse(bomb, "bomb.fbr");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::kBadInput);
  CHECK(refused.error().message.find("than a file of this size can hold") != std::string::npos);
  const auto salvaged = salvage(bomb, "bomb.fbr");
  REQUIRE_FALSE(salvaged);
  CHECK(salvaged.error().code == ErrorCode::kBadInput);
}

TEST_CASE("events and drawings are counted too, however short each is", "[unit]") {
  for (const bool drawings : {false, true}) {
    const int most = drawings ? 100'000 : 20'000;
    CHECK(RecordingReader::parse(withMany(most, drawings), "many.fbr"));
    const std::string more = withMany(most + most / 10, drawings);
    REQUIRE(static_cast<int>(more.size()) < most / 10);
    const auto refused = RecordingReader::parse(more, "more.fbr");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find(drawings ? "more drawings than" : "more events than") !=
          std::string::npos);
  }
}

TEST_CASE("what an event says is as short as a clause", "[unit]") {
  test::Told told;
  told.header = test::sampleHeader();
  RecordedEvent event;
  event.tick = 1;
  event.clause = std::string(5000, 'c');
  event.law = std::string(100, 'l');
  {
    test::Teller teller(told);
    teller.tell(1, false);
    teller.writer().add(event);
    REQUIRE(teller.finish(1));
  }
  const auto reader = RecordingReader::parse(told.bytes, "long.fbr");
  REQUIRE(reader);
  const auto chunk = reader->chunk(0);
  REQUIRE(chunk);
  CHECK(chunk->events.back().clause == event.clause.substr(0, 100));
  CHECK(chunk->events.back().law == event.law);
}

TEST_CASE("plays and ticks have budgets of their own", "[unit]") {
  RecordingHeader header;
  header.bodies.resize(7);
  ChunkHead head;
  head.ticks = 600;
  head.plays = 3;
  DecodingBudget match(60 *
                       1200);  // a chunk of ten seconds takes some 1,200 bytes, also where all stand still
  for (int chunk = 0; chunk < 60; ++chunk) CHECK_FALSE(match.take(head, {}, header));
  head.plays = 256;
  DecodingBudget plays(10000);
  int chunks = 0;
  while (chunks < 10000 && !plays.take(head, {}, header)) ++chunks;
  CHECK(chunks < 15);
  head.plays = 0;
  header.bodies.resize(170);
  head.ticks = 6000;
  DecodingBudget ticks(10000);
  for (chunks = 0; chunks < 10000 && !ticks.take(head, {}, header);) ++chunks;
  CHECK(chunks < 10);
}

TEST_CASE("a header of very many keys is refused before it is understood", "[unit]") {
  RecordingHeader header = test::sampleHeader();
  for (int i = 0; i < 20000; ++i) header.recipe.more.emplace_back(std::to_string(i), "");
  test::Told told;
  told.header = header;
  test::Teller(told).tell(5, true);
  const auto refused = RecordingReader::parse(told.bytes, "keys.fbr");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("keys and values") != std::string::npos);
}

}  // namespace fulbito
