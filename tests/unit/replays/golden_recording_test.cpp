#include "replays/recording_reader.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// One short match of `chaser` and `idle` in every version of the format that there was.
RecordingReader golden(int version) {
  auto reader = RecordingReader::open(FULBITO_GOLDEN_RECORDINGS "/v" + std::to_string(version) + ".fbr");
  REQUIRE(reader);
  return std::move(*reader);
}

/// Everything in a few numbers.
struct Sums {
  std::size_t plays = 0, events = 0, samples = 0, checks = 0;
  double commands = 0.0, ball_x = 0.0, headings = 0.0;
  std::uint64_t hashes = 0, body_hashes = 0;
};

Sums sumsOf(const RecordingReader& reader) {
  Sums sums;
  for (std::size_t i = 0; i < reader.chunkCount(); ++i) {
    const auto chunk = reader.chunk(i);
    REQUIRE(chunk);
    sums.plays += chunk->plays.size();
    sums.events += chunk->events.size();
    sums.samples += chunk->samples.size();
    sums.checks += chunk->checks.size();
    for (const WheelSpeeds& command : chunk->commands) sums.commands += command.left - 0.5 * command.right;
    for (const std::uint16_t hash : chunk->tick_hashes) sums.hashes = 31 * sums.hashes + hash;
    for (const RecordedCheck& check : chunk->checks) {
      CHECK(check.mask == (reader.version() < 4 ? 0xff : 0xffffffff));
      for (const BodyHash& body : check.bodies) {
        sums.body_hashes = 31 * sums.body_hashes + 256 * (body.place & 0xff) + (body.motion & 0xff);
      }
    }
    for (const RecordedSample& sample : chunk->samples) {
      sums.ball_x += sample.poses.back().position.x;
      sums.headings += sample.poses.front().heading;
    }
  }
  return sums;
}

}  // namespace

TEST_CASE("recordings of every version of the format are read", "[unit]") {
  for (std::uint32_t version = 1; version <= kRecordingVersion; ++version) {
    INFO("version " << version);
    const RecordingReader reader = golden(static_cast<int>(version));
    CHECK(reader.version() == version);
    CHECK(reader.finished());
    CHECK(reader.ticks() == 600);
    CHECK(reader.header().recipe.teams == std::vector<std::string>{"chaser", "idle"});
    CHECK(reader.result()->final_hash == 0xbd119ad0e1f45b69u);
    const Sums sums = sumsOf(reader);
    CHECK(sums.plays == 4);
    CHECK(sums.events == 7);
    CHECK(sums.samples == 300);
    CHECK(sums.checks == 10);
    const Sums first = sumsOf(golden(1));
    CHECK(sums.commands == first.commands);
    CHECK(sums.hashes == first.hashes);
    CHECK(sums.body_hashes == first.body_hashes);
    CHECK(sums.ball_x == Approx(first.ball_x).margin(300 * 3e-4));
    CHECK(sums.headings == Approx(first.headings).margin(300 * 4e-3));
  }
}

}  // namespace fulbito
