#include "tournament/report/match_report.hpp"

#include <nlohmann/json.hpp>

#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

StateMaker series(const std::vector<PairResult>& pairs) {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"libero", "classic"}, static_cast<int>(pairs.size())));
  for (std::size_t i = 0; i < pairs.size(); ++i) maker.add({0, 1, 0, i}, pairs[i]);
  return maker;
}

std::vector<PairResult> somePairs() {
  std::vector<PairResult> pairs = {pairOf({3, 1}, {2, 0}, 11), pairOf({1, 1}, {0, 1}, 12),
                                   pairOf({4, 0}, {2, 2}, 13)};
  pairs[0].legs[0].goals_after_foul = {1, 0};
  pairs[1].legs[1].goals_after_foul = {1, 0};
  for (PairResult& pair : pairs) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      PlayRecord& play = pair.legs[leg].play;
      play = {3000, 1500, 300, {}};
      TeamRecord &first = play.teams[leg], &second = play.teams[1 - leg];
      first.shots = 4;
      first.shots_on_goal = 2;
      second.own_goals = 1;
      first.own_third = 600;
      first.robot_ticks = first.field_ticks = 9000;
      first.slow_ticks = 900;
      first.own_half = 1000;
      first.keeper_away = 100;
      second.uncovered = 30;
      second.locks = 2;
      second.longest_contact = leg == 0 ? 60 : 90;
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("the report of a series", "[unit]") {
  CHECK(matchReportText(series(somePairs()).state()) ==
        "libero against classic: 3 swapped pairs, 6 matches\n"
        "vsss-3v3, halves of 30 s, standard physics, seed 1\n"
        "\n"
        "  matches             3 wins, 2 draws, 1 loss of libero\n"
        "  points share        66.7 %  (24.1 ... 92.6 %, 95 %)\n"
        "  goal difference     +1.17 per match  (-2.42 ... +4.75, 95 %)\n"
        "  goals               12 : 5\n"
        "  of these            1 : 1 within 5 s of the scoring team's own foul\n"
        "  verdict             no significant difference (95 %)\n"
        "  goal rate           24.00 : 10.00 per 10 min of play\n"
        "  shots               4.0 : 0.0 per match, on goal 2.0 : 0.0\n"
        "  own goals           0.00 : 1.00 per match\n"
        "  ball                in own third 20.0 : 0.0 %, at a wall 50.0 %, in a corner 10.0 %\n"
        "  slow robots         10.0 : 0.0 %, without keeper 0.0 : 0.0 %\n"
        "  nobody behind ball  0.0 : 1.0 %, without keeper 0.0 : 0.0 %\n"
        "  keeper away         10.0 : 0.0 %\n"
        "  locks               0.00 : 2.00 per match\n"
        "  contacts            of teammates over 0.5 s: 0.0 : 0.0 per match, longest 0.0 : 1.5 s\n"
        "\n"
        "  360.0 s simulated\n");
}

TEST_CASE("the report of one pair has no interval of the goal difference, and tells no times by itself",
          "[unit]") {
  const std::string text = matchReportText(series({pairOf({2, 0}, {1, 0})}).state());
  CHECK(text.find("1 swapped pair, 2 matches\n") != std::string::npos);
  CHECK(text.find("+1.50 per match  (no interval from one pair)") != std::string::npos);
  CHECK(text.ends_with("\n  120.0 s simulated\n"));
}

TEST_CASE("a series that was not finished says so", "[unit]") {
  StateMaker maker = series(somePairs());
  maker.add({0, 1, 0, 3}, std::nullopt);
  CHECK(matchReportText(maker.state()).find("6 matches (stopped early)\n") != std::string::npos);
  CHECK(nlohmann::json::parse(matchReportJson(maker.state()))["complete"] == false);
}

TEST_CASE("the JSON of a series has its figures and each match from A's side", "[unit]") {
  const std::string text = matchReportJson(series(somePairs()).state());
  const auto json = nlohmann::json::parse(text);
  CHECK(json["teams"] == nlohmann::json{{"a", "libero"}, {"b", "classic"}});
  CHECK(json["pairs"] == 3);
  CHECK(json["wins"] == 3);
  CHECK(json["draws"] == 2);
  CHECK(json["losses"] == 1);
  CHECK(json["goals_for"] == 12);
  CHECK(json["goals_after_foul_against"] == 1);
  CHECK(json["better"].is_null());
  CHECK(json["play"]["play_s"] == 300.0);
  CHECK(json["play"]["wall_share"] == 0.5);
  CHECK(json["play"]["corner_share"] == 0.1);
  CHECK(json["play"]["a"]["goals_per_match"] == 2.0);
  CHECK(json["play"]["b"]["goals_per_10min"] == 10.0);
  CHECK(json["play"]["a"]["own_third_share"] == 0.2);
  CHECK(json["play"]["a"]["keeper_away_share"] == 0.1);
  CHECK(json["play"]["b"]["locks_per_match"] == 2.0);
  REQUIRE(json["matches"].size() == 6);
  CHECK(json["matches"][3] == nlohmann::json{{"pair", 1},
                                             {"leg", 2},
                                             {"seed", 12},
                                             {"blue", "b"},
                                             {"goals_a", 0},
                                             {"goals_b", 1},
                                             {"goals_after_foul_a", 0},
                                             {"goals_after_foul_b", 1},
                                             {"simulated_s", 60.0},
                                             {"rejected_a", 0},
                                             {"rejected_b", 0},
                                             {"abandoned", false},
                                             {"final_hash", "0000000000000acc"}});
  // The JSON is written piece by piece, but formatted like a single dump.
  CHECK(text == nlohmann::ordered_json::parse(text).dump(2) + '\n');
  CHECK_FALSE(json.contains("wall_s"));
}

TEST_CASE("a hostile name does not move the matches of the JSON", "[unit]") {
  StateMaker maker = series(somePairs());
  maker.state().plan.entrants[0].name = "x\n  \"matches\": [";
  const auto json = nlohmann::json::parse(matchReportJson(maker.state()));
  CHECK(json["teams"]["a"] == "x\n  \"matches\": [");
  CHECK(json["matches"].size() == 6);
}

TEST_CASE("the report of a test that passes", "[unit]") {
  StateMaker maker = series(std::vector<PairResult>(30, pairOf({3, 1}, {1, 1})));
  maker.test({-50, 0, 0.05, 0.05});
  CHECK(maker.state().counted < 30);
  const std::string pairs = std::to_string(maker.state().counted);
  const std::string text = matchReportText(maker.state());
  CHECK(
      text.starts_with("libero against classic: pass, rather +0 than -50 normalized Elo\n"
                       "  log-likelihood ratio   "));
  CHECK(text.find("\n  pairs                  " + pairs + ": LL 0, LD 0, LW+DD 0, DW " + pairs +
                  ", WW 0\n") != std::string::npos);
  CHECK(text.find("\n  matches                " + pairs + " won, " + pairs + " drawn, 0 lost, goals ") !=
        std::string::npos);
  CHECK(text.find("simulated") == std::string::npos);
  const auto json = nlohmann::json::parse(matchReportJson(maker.state()));
  CHECK(json["verdict"] == "pass");
  CHECK(json["complete"] == true);
  CHECK(json["most_pairs"] == 30);
  CHECK(json["pairs"] == maker.state().counted);
  CHECK(json["bounds"] == nlohmann::json{-50.0, 0.0});
}

TEST_CASE("a test counts the pairs before the first gap only", "[unit]") {
  StateMaker maker = series(std::vector<PairResult>(6, pairOf({3, 1}, {1, 1})));
  maker.state().results[2].reset();
  maker.test({-50, 0, 0.05, 0.05});
  const auto json = nlohmann::json::parse(matchReportJson(maker.state()));
  CHECK(json["pairs"] == 2);
  CHECK(json["wins"] == 2);
  CHECK(json["complete"] == false);
  CHECK(matchReportText(maker.state()).find("inconclusive, stopped before a verdict\n") != std::string::npos);
}
