#include <cmath>

#include <nlohmann/json.hpp>

#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/json_lines.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::json;

MatchConfig chasers() {
  MatchConfig config;
  config.teams = {*parseTeam("chaser"), *parseTeam("chaser")};
  config.rules.half_seconds = 20.0;
  return config;
}

/// A match with all observers that a summary needs.
struct Played {
  StatisticsObserver statistics;
  EventLog log;
  std::string lines;
  EventLines stream{[this](std::string_view line) { lines += line; }};
  MatchReport report;

  explicit Played(const MatchConfig& config, Tick at_most = 1000000) {
    auto match = Match::create(config);
    REQUIRE(match);
    match->watch(statistics);
    match->watch(log);
    match->watch(stream);
    while (match->tick() < at_most && match->step()) {
    }
    match->finish();
    report = reportOf(*match, statistics, log);
    report.wall = 0.5;
  }
};

}  // namespace

TEST_CASE("a match's JSON has the promised keys and the figures of the statistics", "[unit]") {
  const Played played(chasers());
  const Json json = Json::parse(matchJson(played.report));
  for (const char* key : {"schema_version", "teams", "score", "events", "stats", "seed", "build",
                          "final_hash", "simulated_s", "x_realtime"}) {
    CHECK(json.contains(key));
  }
  CHECK(json["teams"]["blue"] == "chaser");
  CHECK(json["score"]["complete"] == true);
  CHECK(json["score"]["goals"].size() == played.report.statistics.goals.size());
  CHECK(json["events"].size() == played.report.events.size());
  CHECK(json["stats"]["blue"]["robots"].size() == 3);
  CHECK(json["stats"]["blue"]["goals_after_foul"] == played.report.statistics.teams[0].goals_after_foul);
  const MatchStatistics& counted = played.report.statistics;
  CHECK(json["stats"]["wall_share"] == counted.atWall());
  CHECK(json["stats"]["corner_share"] == counted.inCorner());
  CHECK(json["stats"]["blue"]["slow_share"] == counted.teams[0].play.slow());
  CHECK(json["stats"]["blue"]["uncovered_share"] == counted.uncovered(TeamId::kBlue));
  CHECK(json["stats"]["blue"]["keeper_away_share"] == counted.teams[0].play.keeperAway());
  CHECK(json["stats"]["yellow"]["locks"] == counted.teams[1].play.locks);
  for (const auto& [clause, count] : json["stats"]["calls"].items()) CHECK(count["paid"].contains("yellow"));
  CHECK(json["stats"]["play_s"].get<double>() == Approx(40.0));
  CHECK(json["x_realtime"].get<double>() == Approx(json["simulated_s"].get<double>() / 0.5));
  CHECK(json["stats"]["blue"]["possession_share"].get<double>() +
            json["stats"]["yellow"]["possession_share"].get<double>() ==
        Approx(1.0));
}

TEST_CASE("statistics agree with the referee", "[unit]") {
  const Played played(chasers());
  PerTeam<int> goals{};
  for (const GoalRecord& goal : played.report.statistics.goals) ++goals[indexOf(goal.team)];
  CHECK(goals == played.report.referee.score);
  std::size_t restarts = 0;
  for (const LoggedEvent& event : played.report.events) restarts += event.restart ? 1 : 0;
  int counted = 0;
  for (const PerTeam<int>& kind : played.report.statistics.restarts) counted += kind[0] + kind[1];
  CHECK(counted == static_cast<int>(restarts));
}

TEST_CASE("a match that is stopped early says so", "[unit]") {
  const Played played(chasers(), 300);
  CHECK(Json::parse(matchJson(played.report))["score"]["complete"] == false);
  CHECK(matchText(played.report).find("stopped early") != std::string::npos);
  CHECK(test::jsonLines(played.lines).back()["complete"] == false);
}

TEST_CASE("the summary tells score, table, speed and hash; the profile when it was measured", "[unit]") {
  Played played(chasers());
  const std::string text = matchText(played.report);
  for (const char* part :
       {"chaser (blue) ", "possession", "shots (on goal)", "ball in own third", "at a wall (in a corner)",
        "slower than 0.05 m/s", "nobody behind ball", "keeper away", "longest contact", "distance driven",
        "contacts with opponents", "commands rejected", "goals within 5 s of own foul", "kick-offs",
        "x real time", "final hash", "seed 1"}) {
    INFO(part);
    CHECK(text.find(part) != std::string::npos);
  }
  CHECK(text.find("physics  ") == std::string::npos);
  played.report.profile = MatchProfile{1, 2, 3, 60, 5, 6, 23, 10};
  CHECK(matchText(played.report).find("physics       60.0 %") != std::string::npos);
  played.report.statistics.calls = {{"goal-kick.attackers", {4, 2}, 0, {3, 0}}};
  const std::string paid = matchText(played.report);
  CHECK(paid.find("4 (3 paid)             2\n") != std::string::npos);
  CHECK(Json::parse(matchJson(played.report))["compute_profile"]["physics_ns"] == 60);
}

TEST_CASE("event lines: a header, the log's events, the end", "[unit]") {
  const Played played(chasers());
  const std::vector<Json> lines = test::jsonLines(played.lines);
  REQUIRE(lines.size() == played.report.events.size() + 2);
  CHECK(lines.front()["event"] == "match");
  CHECK(lines.front()["schema_version"] == 1);
  CHECK(lines[1]["event"] == "restart");
  CHECK(lines[1]["kind"] == "kick-off");
  CHECK(lines.back()["event"] == "end");
  CHECK(lines.back()["complete"] == true);
  const Json json = Json::parse(matchJson(played.report));
  for (std::size_t i = 0; i < json["events"].size(); ++i) CHECK(json["events"][i] == lines[i + 1]);
}

TEST_CASE("the event log is bounded and counts what it leaves out", "[unit]") {
  auto match = Match::create(chasers());
  REQUIRE(match);
  EventLog all, one(1);
  match->watch(all);
  match->watch(one);
  while (match->step()) {
  }
  CHECK(one.events().size() == 1);
  CHECK(one.leftOut() + 1 == all.events().size());
}

TEST_CASE("contacts with opponents are in both columns, next to those with teammates", "[unit]") {
  Played played(chasers(), 10);
  played.report.statistics.opponent_contacts = 83;
  const std::string text = matchText(played.report);
  const std::size_t mates = text.find("contacts with teammates"),
                    opponents = text.find("contacts with opponents");
  const std::string row = text.substr(opponents, text.find('\n', opponents) - opponents);
  CHECK(text.find('\n', mates) + 3 == opponents);
  CHECK(row.find("83") != row.rfind("83"));
}

TEST_CASE("a speed has two digits at least, and is left out where it is not known", "[unit]") {
  CHECK(paceText(8.3, 33.77) == "0.25 x real time");
  CHECK(paceText(8.3, 1.0) == "8.3 x real time");
  CHECK(paceText(99.6, 10.0) == "10 x real time");
  CHECK(paceText(60.0, 0.01) == "6000 x real time");
  CHECK(paceText(60.0, 0.0).empty());
  Played played(chasers(), 10);
  played.report.wall = 0.0;
  CHECK(matchText(played.report).find("real time") == std::string::npos);
}

TEST_CASE("goals stand in the summary at the clock's time, cut to tenths", "[unit]") {
  Played played(chasers(), 10);
  played.report.statistics.goals = {
      {417.95, 2, 117.95, TeamId::kBlue, RobotId{TeamId::kBlue, 1}, false, {1, 0}}};
  CHECK(matchText(played.report).find("6:57.9  2nd half  1:57.9   1 : 0") != std::string::npos);
}

}  // namespace fulbito
