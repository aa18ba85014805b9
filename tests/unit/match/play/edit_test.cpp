#include "match/play/edit.hpp"

#include <limits>

#include "fulbito/recorder.hpp"
#include "fulbito/recording.hpp"
#include "fulbito/statistics.hpp"
#include "replays/verify/verify.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Pose2& robot(Placement& placement, TeamId team, std::size_t number) {
  return *placement.robots[indexOf(team)][number];
}

/// The flaw after `change` was applied to a kick-off.
std::string flawAfter(const std::function<void(Placement&)>& change) {
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  match->makeReady();
  Placement after = match->placement();
  change(after);
  return flawOfEdit(match->config(), match->placement(), after).value_or("");
}

void play(Match& match, int ticks) {
  for (int i = 0; i < ticks; ++i) REQUIRE(match.step());
}

/// The present placement, with the ball at a free place.
Placement withFreeBall(const Match& match) {
  Placement wanted = match.placement();
  wanted.ball_velocity = {};
  for (const double y : {0.5, 0.25, -0.25, -0.5}) {
    wanted.ball = {0.0, y};
    if (!flawOfEdit(match.config(), match.placement(), wanted)) break;
  }
  return wanted;
}

struct Plays final : MatchObserver {
  std::vector<std::pair<Tick, bool>> seen;
  void onPlayStart(const PlayStart& start) override { seen.emplace_back(start.tick, start.edited); }
};

}  // namespace

TEST_CASE("an edit is judged by what it moves", "[unit]") {
  CHECK(flawAfter([](Placement&) {}).empty());
  CHECK(flawAfter([](Placement& p) { p.ball = {0.3, -0.2}; }).empty());
  CHECK(flawAfter([](Placement& p) { p.ball = {5.0, 0.0}; }) == "the ball would not be on the field");
  CHECK(flawAfter([](Placement& p) { p.ball = {0.78, 0.0}; }) == "the ball would not be on the field");
  CHECK(flawAfter([](Placement& p) { p.ball = {kNaN, 0.0}; }) == "the ball would not be on the field");
  CHECK(flawAfter([](Placement& p) { p.ball_velocity = {60.0, 0.0}; }) == "the ball would be too fast");
  CHECK(flawAfter([](Placement& p) { p.ball = robot(p, TeamId::kBlue, 0).position; }) ==
        "blue robot 0 would overlap the ball");
  CHECK(flawAfter([](Placement& p) { robot(p, TeamId::kBlue, 1) = robot(p, TeamId::kYellow, 2); }) ==
        "blue robot 1 would overlap a robot");
  CHECK(flawAfter([](Placement& p) { robot(p, TeamId::kYellow, 2).position = {0.0, 0.7}; }) ==
        "yellow robot 2 would not be on the field");
  CHECK(flawAfter([](Placement& p) { robot(p, TeamId::kYellow, 2).heading = kNaN; }) ==
        "yellow robot 2 would not be on the field");
  CHECK(flawAfter([](Placement& p) { p.robots[0][1].reset(); }) == "no robot may be added or removed");
  CHECK(flawAfter([](Placement& p) { p.robots[1][5] = Pose2{}; }) == "no robot may be added or removed");
}

TEST_CASE("what was not moved may lean on others", "[unit]") {
  const MatchConfig config = shortMatch();
  auto match = Match::create(config);
  REQUIRE(match);
  match->makeReady();
  Placement before = match->placement();
  // Two robots overlap as physics never leaves them, and a third one is moved.
  robot(before, TeamId::kBlue, 1) = robot(before, TeamId::kYellow, 1);
  Placement after = before;
  after.ball = {-0.1, 0.5};
  CHECK_FALSE(flawOfEdit(config, before, after));
  robot(after, TeamId::kBlue, 1).position.x += 0.01;
  CHECK(flawOfEdit(config, before, after));
}

TEST_CASE("a refused edit changes nothing", "[unit]") {
  const MatchConfig config = shortMatch();
  auto match = Match::create(config);
  REQUIRE(match);
  play(*match, 30);
  Placement wrong = match->placement();
  wrong.ball = {9.0, 0.0};
  const auto replaced = match->replace(wrong);
  REQUIRE_FALSE(replaced);
  CHECK(replaced.error().code == ErrorCode::kUsage);
  REQUIRE(match->advance() == MatchPhase::kDeciding);
  CHECK_FALSE(match->replace(match->placement()));  // amid a tick
  while (match->step()) {
  }
  CHECK(match->hash() == hashOf(config));
  CHECK(match->edits() == 0);
  CHECK_FALSE(match->replace(match->placement()));  // over
}

TEST_CASE("play goes on from an edit, at once and at rest", "[unit]") {
  auto match = Match::create(shortMatch("idle", "idle", 20.0));
  REQUIRE(match);
  Plays plays;
  match->watch(plays);
  play(*match, 100);
  const Tick clock = match->referee().play_ticks;
  Placement wanted = match->placement();
  wanted.ball = {0.3, 0.3};
  wanted.ball_velocity = {0.5, 0.0};
  robot(wanted, TeamId::kYellow, 0) = {{0.5, -0.4}, 1.0};
  REQUIRE(match->replace(wanted));
  CHECK(distance(match->world().balls.front().position, {0.3, 0.3}) < 1e-6);
  CHECK(match->placement().robots[1][0]->heading == Approx(1.0));
  CHECK(match->edits() == 0);  // nothing has changed yet
  wanted.ball = {0.2, 0.3};
  REQUIRE(match->replace(wanted));
  play(*match, 1);
  CHECK(match->edits() == 1);
  CHECK(match->tick() == 101);
  CHECK(match->referee().playing);
  CHECK(match->referee().play_ticks == clock + 1);
  CHECK(match->world().balls.front().position.x > 0.2);
  CHECK(plays.seen == std::vector<std::pair<Tick, bool>>{{0, false}, {100, true}});
}

TEST_CASE("an edited match verifies and says that it was edited", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  for (const RecordingLevel level : {RecordingLevel::kFull, RecordingLevel::kRecipe}) {
    std::string bytes;
    auto match = Match::create(config);
    auto recorder = MatchRecorder::create(into(bytes), config, level);
    REQUIRE(match);
    REQUIRE(recorder);
    StatisticsObserver statistics;
    EventLog log;
    match->watch(statistics);
    match->watch(log);
    match->watch(*recorder);
    match->makeReady();
    Placement last;
    for (const Tick edited : {0, 7, 299, 300, 301, 302, 601}) {
      while (match->tick() < edited) REQUIRE(match->step());
      last = withFreeBall(*match);
      REQUIRE(match->replace(last));
    }
    while (match->step()) {
    }
    const auto reader = RecordingReader::parse(bytes, "edited");
    REQUIRE(reader);
    const auto verified = verify(*reader);
    REQUIRE(verified);
    CHECK(verified->same());
    CHECK(verified->final_hash == match->hash());
    REQUIRE(reader->result()->figures.size() == 1);
    CHECK(reader->result()->figures.front() == std::pair<std::string, double>{"edits", 7.0});
    const MatchReport report = reportOf(*match, statistics, log);
    CHECK(matchText(report).find(", edited") != std::string::npos);
    CHECK(matchJson(report).find("\"edited\": true") != std::string::npos);
    if (level == RecordingLevel::kRecipe) continue;
    const auto timeline = ReplayTimeline::read(*reader);
    REQUIRE(timeline);
    CHECK(timeline->at(601.0 / 60.0).bodies.back()->position == last.ball);
  }
}

TEST_CASE("a match that ends before its first tick, edited or not, leaves a recording of its start",
          "[unit]") {
  for (const bool edited : {false, true}) {
    const MatchConfig config = shortMatch();
    std::string bytes;
    auto match = Match::create(config);
    auto recorder = MatchRecorder::create(into(bytes), config);
    REQUIRE(match);
    REQUIRE(recorder);
    match->watch(*recorder);
    match->makeReady();
    Placement wanted = match->placement();
    wanted.ball = {0.4, 0.4};
    if (edited) REQUIRE(match->replace(wanted));
    match->finish();
    const auto reader = RecordingReader::parse(bytes, "empty");
    REQUIRE(reader);
    const auto timeline = ReplayTimeline::read(*reader);
    REQUIRE(timeline);
    CHECK(timeline->at(0.0).bodies.back()->position == (edited ? Vec2{0.4, 0.4} : Vec2{}));
    REQUIRE(verify(*reader));
  }
}

}  // namespace fulbito
