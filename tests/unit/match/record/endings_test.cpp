#include <array>
#include <functional>
#include <string>
#include <vector>

#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "match/record/recorded_events.hpp"
#include "replays/export/tables.hpp"
#include "replays/header/header_json.hpp"
#include "replays/html/html_page.hpp"
#include "replays/html/recorded_scene.hpp"
#include "replays/verify/cut.hpp"
#include "replays/verify/verify.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// A team that is lost from its n-th decision on.
class LostTeam final : public Strategy {
 public:
  explicit LostTeam(int from) : left_(from) {}
  void begin(const MatchInfo&) override {}
  TeamCommand decide(const Observation&) override {
    if (--left_ <= 0) {
      condition_.state = TeamCondition::State::kLost;
      condition_.failures = 3;
      condition_.reason = "ended\nby itself";
    }
    return allWheels({4.0, 4.0});
  }
  const TeamCondition& condition() const override { return condition_; }

 private:
  int left_;
  TeamCondition condition_;
};

TeamChoice lostFrom(int decision) {
  return TeamChoice::own("lost", [decision] { return std::make_unique<LostTeam>(decision); });
}

/// A way in which a match ends.
struct Ending {
  const char* name;
  std::function<void(MatchConfig&)> prepare;
  std::optional<PerTeam<int>> score;  ///< score at the end, if it is known beforehand
  int ticks = 100'000;                ///< largest number of ticks to play
  bool edited = false;
};

/// Sends the ball into yellow's goal.
void shoot(MatchConfig& config) {
  Placement start = twoColumns();
  start.ball = {config.field.length / 2 - 0.12, 0.0};
  start.ball_velocity = {1.5, 0.0};
  for (auto& robot : start.robots[1]) robot->position.y += 0.35;
  config.start = start;
}

void board(MatchConfig& config, int blue, int yellow) { config.scoreboard.score = {blue, yellow}; }

std::vector<Ending> endings() {
  using C = MatchConfig;
  return {
      {"draw", [](C&) {}, PerTeam<int>{0, 0}},
      {"a goal and full time", shoot, {}},
      {"overtime, no goal", [](C& c) { c.rules.periods.tie_break = TieBreak::kOvertime; }, {}},
      {"golden goal",
       [](C& c) {
         shoot(c);
         c.scoreboard.period = 2;
         c.rules.periods.tie_break = TieBreak::kOvertime;
       },
       {}},
      {"shoot-out", [](C& c) { c.rules.periods.tie_break = TieBreak::kShootOut; }, PerTeam<int>{0, 0}},
      {"overtime and shoot-out", [](C& c) { c.rules.periods.tie_break = TieBreak::kBoth; }, {}},
      {"mercy",
       [](C& c) {
         shoot(c);
         board(c, 8, 1);
         c.rules.periods.mercy_goals = 8;
       },
       PerTeam<int>{9, 1}},
      {"blue absent, forfeit",
       [](C& c) {
         c.present = {false, true};
         c.rules.walk_over.mode = WalkOver::kForfeit;
       },
       PerTeam<int>{-1, 0}},
      {"yellow absent, the other plays", [](C& c) { c.present = {true, false}; }, {}},
      {"both absent", [](C& c) { c.present = {false, false}; }, PerTeam<int>{-3, -3}},
      {"blue fails", [](C& c) { c.teams[0] = lostFrom(20); }, PerTeam<int>{-1, 0}},
      {"yellow fails when behind",
       [](C& c) {
         c.teams[1] = lostFrom(3);
         board(c, 37, 2);
       },
       PerTeam<int>{37, -38}},
      {"both fail",
       [](C& c) {
         c.teams = {lostFrom(9), lostFrom(9)};
         c.rules.walk_over.both_absent_score = -100;
       },
       {}},
      {"stopped", [](C&) {}, PerTeam<int>{0, 0}, 17},
      {"edited by hand", [](C&) {}, PerTeam<int>{0, 0}, 100'000, true},
  };
}

MatchConfig configFor(const std::string& profile, const Ending& ending) {
  auto config = MatchConfig::standard("idle", "idle", profile);
  REQUIRE(config);
  Rules& rules = config->rules;
  rules.half_seconds = rules.periods.overtime_seconds = rules.walk_over.seconds = 0.7;
  rules.shoot_out.kicks = rules.shoot_out.max_kicks = 2;
  rules.shoot_out.kick_seconds = 0.2;
  rules.periods.tie_break = TieBreak::kNone;
  ending.prepare(*config);
  return *config;
}

/// Plays to the ending and returns the recording.
std::string play(const MatchConfig& config, const Ending& ending, RecordingLevel level, PerTeam<int>& score) {
  std::string bytes;
  auto match = Match::create(config);
  REQUIRE(match);
  auto recorder = MatchRecorder::create(into(bytes), config, level);
  REQUIRE(recorder);
  match->watch(*recorder);
  for (int tick = 0; tick < ending.ticks && match->step(); ++tick) {
    if (!ending.edited || tick != 10) continue;
    Placement moved = match->placement();
    moved.ball.y += 0.1;
    REQUIRE(match->replace(moved));
  }
  match->finish();
  REQUIRE(recorder->written());
  score = match->referee().score;
  return bytes;
}

/// Checks everything that can be made of a recording without a window or ffmpeg.
void checkProducts(const RecordingReader& reader, const PerTeam<int>& score) {
  const auto verified = verify(reader);
  REQUIRE(verified);
  CHECK(verified->same());
  const auto timeline = ReplayTimeline::read(reader);
  REQUIRE(timeline);
  CHECK(timeline->at(timeline->seconds()).score == score);
  std::string csv, lines;
  writeCsv(*timeline, 0.0, timeline->seconds(), [&](const std::string& line) { csv += line; });
  writeJsonLines(*timeline, 0.0, timeline->seconds(), [&](const std::string& line) { lines += line; });
  CHECK(csv.starts_with("tick,time_s,"));
  CHECK(lines.find("\"recording\"") != std::string::npos);
  const auto scene = recordedScene(reader, *timeline);
  REQUIRE(scene);
  const auto page = htmlPage({PageKind::kReplay, "a match", {*scene}});
  REQUIRE(page);
  CHECK(page->find("\"score\":[" + std::to_string(score[0]) + "," + std::to_string(score[1]) + "]") !=
        std::string::npos);
  const auto events = eventsOf(reader);
  REQUIRE(events);
  if (!events->empty() && reader.result()->complete) CHECK(events->back().score == score);
  const auto cut = cutPlays(reader, {0, verified->plays - 1});
  REQUIRE(cut);
  CHECK(RecordingReader::parse(*cut, "cut.fbr")->ticks() == reader.ticks());
}

}  // namespace

TEST_CASE("a recording of a match that ends in any way, by any profile, reads, verifies and exports",
          "[unit]") {
  int below_zero = 0, stopped = 0;
  for (const std::string& profile : rulesPresetNames()) {
    for (const Ending& ending : endings()) {
      INFO(profile << ": " << ending.name);
      const MatchConfig config = configFor(profile, ending);
      PerTeam<int> score{};
      const auto reader =
          RecordingReader::parse(play(config, ending, RecordingLevel::kFull, score), "match.fbr");
      INFO((reader ? "" : reader.error().message));
      REQUIRE(reader);
      CHECK(reader->finished());
      CHECK(reader->result()->score == score);
      if (ending.score) CHECK(score == *ending.score);
      below_zero += score[0] < 0 || score[1] < 0 ? 1 : 0;
      stopped += reader->result()->complete ? 0 : 1;
      checkProducts(*reader, score);
    }
  }
  CHECK(below_zero >= 5 * 4);
  CHECK(stopped == 4);
}

TEST_CASE("scores of a result are read as far below zero as above, and no further", "[unit]") {
  for (const int goals : {-1'100'000, -37, -1, 0, 1, 1'100'000}) {
    RecordingResult result;
    result.score = {goals, -goals};
    const auto read = resultFromJson(toJson(result));
    REQUIRE(read);
    CHECK(read->score == result.score);
  }
  for (const char* goals : {"-1100001", "1100001", "0.5", "\"1\"", "1e3", "99999999999999999999", "null"}) {
    std::string text = toJson(RecordingResult{});
    text.replace(text.find("[0,"), 3, "[" + std::string(goals) + ",");
    const auto read = resultFromJson(text);
    INFO(text);
    REQUIRE_FALSE(read);
    CHECK(read.error().find("score[0] is not a score") != std::string::npos);
  }
}

TEST_CASE("a recipe verifies too, in whatever way its match ends", "[unit]") {
  const std::vector<Ending> all = endings();
  for (const Ending& ending : all) {
    PerTeam<int> score{};
    const MatchConfig config = configFor("vsss-3v3", ending);
    const auto reader =
        RecordingReader::parse(play(config, ending, RecordingLevel::kRecipe, score), "recipe.fbr");
    INFO(ending.name);
    REQUIRE(reader);
    CHECK(reader->result()->score == score);
    CHECK(verify(*reader)->same());
  }
}

}  // namespace fulbito
