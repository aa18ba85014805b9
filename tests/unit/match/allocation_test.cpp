#include "fulbito/recorder.hpp"
#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/malloc_counter.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Number of a match's ticks that allocated memory, once warm. Ticks that end in a restart are not counted.
int allocatingTicks(const MatchConfig& config, Tick warm_up,
                    const std::vector<MatchObserver*>& watching = {}) {
  auto match = Match::create(config);
  REQUIRE(match);
  for (MatchObserver* observer : watching) match->watch(*observer);
  int count = 0;
  for (bool more = true; more;) {
    const long before = mallocCount();
    more = match->step();
    const bool restarted = match->world().tick == 0;
    if (match->tick() > warm_up && !restarted && more && mallocCount() != before) ++count;
  }
  return count;
}

/// The same while it is recorded; ticks that end a chunk are not counted.
int allocatingTicksRecorded(const MatchConfig& config, Tick warm_up) {
  auto match = Match::create(config);
  auto recorder = MatchRecorder::create([](std::string_view) { return Result<void>(); }, config);
  REQUIRE(match);
  REQUIRE(recorder);
  match->watch(*recorder);
  int count = 0;
  for (bool more = true; more;) {
    const long before = mallocCount();
    more = match->step();
    const bool left_out = match->world().tick == 0 || match->tick() % RecordingHeader{}.chunk_ticks == 1;
    if (match->tick() > warm_up && !left_out && more && mallocCount() != before) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("recording a warm match allocates only where chunks end", "[unit]") {
  CHECK(allocatingTicksRecorded(shortMatch("chaser", "chaser", 60.0), 600) == 0);
}

TEST_CASE("statistics and the event log of a warm match allocate nothing", "[unit]") {
  StatisticsObserver statistics;
  EventLog log;
  CHECK(allocatingTicks(shortMatch("chaser", "chaser", 60.0), 600, {&statistics, &log}) == 0);
  CHECK(statistics.statistics().play_ticks > 600);
}

TEST_CASE("a warm match's ticks allocate nothing", "[unit]") {
  for (const auto& team : TeamCatalogue::builtIn().teams()) {
    CAPTURE(team->name);
    MatchConfig config = shortMatch(team->name, team->name, 30.0);
    CHECK(allocatingTicks(config, 600) == 0);
    for (VisionModel& seat : config.vision) seat.latency_ticks = 4;
    for (VisionModel& seat : config.vision) seat.position_noise = 0.001;
    for (VisionModel& seat : config.vision) seat.dropout = 0.05;
    CHECK(allocatingTicks(config, 600) == 0);
  }
}

}  // namespace fulbito
