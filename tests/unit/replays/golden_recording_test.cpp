#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// A committed recording of a short match of `chaser` and `idle`, which is never written again.
RecordingReader golden() {
  auto reader = RecordingReader::open(FULBITO_GOLDEN_RECORDINGS "/chaser-idle.fbr");
  REQUIRE(reader);
  return std::move(*reader);
}

/// Sums over the content of a recording.
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
      for (const BodyHash& body : check.bodies) {
        sums.body_hashes = 31 * (31 * sums.body_hashes + body.place) + body.motion;
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

TEST_CASE("a recording that was written long ago is read as it was", "[unit]") {
  const RecordingReader reader = golden();
  CHECK(reader.finished());
  CHECK(reader.ticks() == 600);
  CHECK(reader.header().recipe.teams == std::vector<std::string>{"chaser", "idle"});
  CHECK(reader.result()->final_hash == 0xbd119ad0e1f45b69u);
  const Sums sums = sumsOf(reader);
  CHECK(sums.plays == 4);
  CHECK(sums.events == 7);
  CHECK(sums.samples == 300);
  CHECK(sums.checks == 10);
  CHECK(sums.commands == Approx(18559.37).margin(1e-6));
  CHECK(sums.hashes == 0x4d693ffa23b9c925u);
  CHECK(sums.body_hashes == 0x82de5287532b9d26u);
  CHECK(sums.ball_x == Approx(45.2765).margin(1e-6));
  CHECK(sums.headings == Approx(-19.4079249283).margin(1e-6));
}

}  // namespace fulbito
