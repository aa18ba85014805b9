#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// The referee's clock and score after each tick.
struct Table final : MatchObserver {
  std::vector<RefereeState> states;
  std::vector<WorldState> worlds;
  void onTick(const MatchTick& tick) override {
    states.push_back(*tick.referee);
    worlds.push_back(*tick.world);
  }
};

}  // namespace

TEST_CASE("a replay's clock and score are the referee's", "[unit]") {
  MatchConfig config = shortMatch("chaser", "classic", 40.0);
  Table table;
  const auto reader = RecordingReader::parse(recorded(config, RecordingLevel::kFull, &table), "match");
  REQUIRE(reader);
  const auto timeline = ReplayTimeline::read(*reader);
  REQUIRE(timeline);
  CHECK(timeline->plays().size() > 3);
  ReplayMoment moment;
  for (Tick tick = 1; tick <= timeline->ticks(); ++tick) {
    timeline->at(timeline->secondsAt(tick), moment);
    // At a restart, a replay shows the next play and its clock, so the tick before is compared.
    if (timeline->plays()[moment.play].tick == tick) continue;
    const RefereeState& truth = table.states[static_cast<std::size_t>(tick) - 1];
    INFO("tick " << tick);
    REQUIRE(moment.play_seconds == static_cast<double>(truth.play_ticks) / 60.0);
    REQUIRE(moment.playing == truth.playing);
    REQUIRE(moment.period == truth.period);
    REQUIRE(moment.score == truth.score);
    REQUIRE(moment.blue_side == truth.blue_side);
    const WorldState& world = table.worlds[static_cast<std::size_t>(tick) - 1];
    REQUIRE(distance(moment.bodies.back()->position, world.balls.front().position) < 0.04);
  }
}

}  // namespace fulbito
