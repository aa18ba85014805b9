#include "replays/verify/cut.hpp"

#include "match/record/recorded_events.hpp"
#include "replays/verify/repair.hpp"
#include "replays/verify/verify.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

std::vector<RecordedPlay> playsOf(const RecordingReader& reader) {
  std::vector<RecordedPlay> plays;
  for (std::size_t i = 0; i < reader.chunkCount(); ++i) {
    const auto chunk = reader.chunk(i);
    REQUIRE(chunk);
    plays.insert(plays.end(), chunk->plays.begin(), chunk->plays.end());
  }
  return plays;
}

std::string longMatch(RecordingLevel level = RecordingLevel::kFull) {
  return recorded(shortMatch("chaser", "chaser", 60.0), level);
}

/// Offset in the file of the begin of chunk number `index`, found by the letters of its type.
std::size_t chunkOffset(const std::string& bytes, int index) {
  std::size_t at = bytes.find("CHNK");
  for (; index > 0; --index) at = bytes.find("CHNK", at + 1);
  return at - 8;
}

}  // namespace

TEST_CASE("a cut holds its plays whole, goes on with the hash, and verifies", "[unit]") {
  for (const RecordingLevel level : {RecordingLevel::kFull, RecordingLevel::kRecipe}) {
    const RecordingReader whole = readerOf(longMatch(level));
    const std::vector<RecordedPlay> plays = playsOf(whole);
    REQUIRE(plays.size() > 5);
    const auto bytes = cutPlays(whole, {2, 3});
    REQUIRE(bytes);
    const RecordingReader cut = readerOf(*bytes);
    CHECK(cut.finished());
    CHECK(cut.header().level == level);
    CHECK(cut.ticks() == plays[4].tick - plays[2].tick);
    const auto verified = verify(cut);
    REQUIRE(verified);
    CHECK(verified->same());
    CHECK(verified->plays == 2);
    CHECK(verified->final_hash == plays[4].hash);
    CHECK(cut.result()->score == plays[4].score);
    CHECK_FALSE(cut.result()->complete);
    const auto& more = cut.header().recipe.more;
    const std::string noted = "3-4 of " + std::to_string(plays.size());
    CHECK(std::find(more.begin(), more.end(), std::pair<std::string, std::string>{"cut_plays", noted}) !=
          more.end());
  }
}

TEST_CASE("a cut has the events of its plays, at their new times", "[unit]") {
  const RecordingReader whole = readerOf(longMatch());
  const auto all = eventsOf(whole);
  const Tick begin = playsOf(whole)[2].tick, end = playsOf(whole)[5].tick;
  const auto bytes = cutPlays(whole, {2, 4});
  REQUIRE(bytes);
  const auto events = eventsOf(readerOf(*bytes));
  REQUIRE(events);
  std::vector<std::pair<Tick, std::string>> expected, found;
  for (const ReplayEvent& event : *all) {
    const Tick tick = event.call.tick;
    const bool before = tick < begin || (tick == begin && !event.restart && event.call.clause != "placement");
    const bool after = tick > end || (tick == end && (event.restart || event.call.clause == "placement"));
    if (!before && !after) expected.emplace_back(tick - begin, event.call.clause);
  }
  for (const ReplayEvent& event : *events) found.emplace_back(event.call.tick, event.call.clause);
  CHECK(found == expected);
  CHECK(found.size() >= 6);
}

TEST_CASE("a cut of all plays has the whole match's states and end", "[unit]") {
  const RecordingReader whole = readerOf(longMatch());
  const auto count = static_cast<std::int64_t>(playsOf(whole).size());
  const auto bytes = cutPlays(whole, {0, count - 1});
  REQUIRE(bytes);
  const RecordingReader cut = readerOf(*bytes);
  CHECK(cut.ticks() == whole.ticks());
  CHECK(cut.result()->complete);
  CHECK(cut.result()->final_hash == whole.result()->final_hash);
}

TEST_CASE("seconds choose every play with a part in them; what is not there is said", "[unit]") {
  const RecordingReader whole = readerOf(longMatch());
  const std::vector<RecordedPlay> plays = playsOf(whole);
  const double third = static_cast<double>(plays[2].tick) / 60.0;
  CHECK(playsBetween(whole, third + 0.1, third + 0.2)->first == 2);
  CHECK(playsBetween(whole, third + 0.1, third + 0.2)->last == 2);
  CHECK(playsBetween(whole, third - 0.1, third + 0.2)->first == 1);
  CHECK(playsBetween(whole, 0.0, 1e9)->last == static_cast<std::int64_t>(plays.size()) - 1);
  CHECK(playsBetween(whole, 1e6, 1e9).error().code == ErrorCode::kUsage);
  CHECK(playsBetween(whole, 3.0, 3.0).error().code == ErrorCode::kUsage);
  CHECK(cutPlays(whole, {5, 4}).error().code == ErrorCode::kUsage);
  CHECK(cutPlays(whole, {0, 1000}).error().code == ErrorCode::kUsage);
}

TEST_CASE("a repair keeps what precedes the damage and the plays that begin after it", "[unit]") {
  std::string bytes = longMatch();
  const RecordingReader whole = readerOf(bytes);
  bytes[chunkOffset(bytes, 5) + 100] ^= 8;
  REQUIRE_FALSE(RecordingReader::parse(bytes, "game.fbr"));
  const auto found = salvage(bytes, "game.fbr");
  REQUIRE(found);
  CHECK_FALSE(found->whole);
  CHECK(found->chunks.size() == whole.chunkCount() - 1);
  const auto repaired = repair(*found);
  REQUIRE(repaired);
  CHECK(repaired->gaps == 1);
  CHECK_FALSE(repaired->end_lost);
  // At most the lost chunk, and the rest of the play that continued after it.
  CHECK(repaired->lost_ticks >= 360);
  CHECK(repaired->lost_ticks < 3000);
  CHECK(repaired->ticks == whole.ticks() - repaired->lost_ticks);
  const RecordingReader mended = readerOf(repaired->bytes);
  CHECK(mended.finished());
  CHECK(mended.ticks() == repaired->ticks);
  CHECK(mended.result()->score == whole.result()->score);
  const auto verified = verify(mended);
  REQUIRE(verified);
  CHECK(verified->same());
  CHECK(verified->plays == repaired->plays);
}

TEST_CASE("a cut file is repaired up to its last whole chunk", "[unit]") {
  std::string bytes = longMatch();
  bytes.resize(chunkOffset(bytes, 7) + 50);
  const auto found = salvage(bytes, "game.fbr");
  REQUIRE(found);
  CHECK(found->lost_bytes == 50);
  const auto repaired = repair(*found);
  REQUIRE(repaired);
  CHECK(repaired->ticks == 2520);
  CHECK(repaired->end_lost);
  CHECK(repaired->gaps == 0);
  CHECK(verify(readerOf(repaired->bytes))->same());
}

TEST_CASE("what is whole is left alone, and without a header or a play nothing can be kept", "[unit]") {
  std::string bytes = longMatch();
  CHECK(salvage(bytes, "game.fbr")->whole);
  CHECK(salvage(bytes, "game.fbr")->lost_bytes == 0);
  const auto nothing = salvage(bytes.substr(0, chunkOffset(bytes, 0)), "game.fbr");
  REQUIRE(nothing);
  CHECK(repair(*nothing).error().code == ErrorCode::kBadInput);
  bytes[60] ^= 1;
  CHECK(salvage(bytes, "game.fbr").error().code == ErrorCode::kBadInput);
  CHECK(salvage(std::string("/nonexistent.fbr")).error().code == ErrorCode::kIo);
}

}  // namespace fulbito
