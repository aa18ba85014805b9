#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

nlohmann::json jsonOf(const TournamentState& state) {
  return nlohmann::json::parse(tournamentJson(state, tableOf(state)));
}

}  // namespace

TEST_CASE("the JSON of a tournament has entrants, standings and meetings", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"a", "b", "c"});
  maker.state().plan.book.kinds = {StartKind::kKickOff, StartKind::kPlay};
  const auto json = jsonOf(maker.state());
  CHECK(json["schema_version"] == 1);
  CHECK(json["format"] == "round-robin");
  CHECK(json["finished"] == true);
  CHECK(json["pairs_counted"] == 3);
  REQUIRE(json["entrants"].size() == 3);
  CHECK(json["entrants"][1]["name"] == "b");
  CHECK(json["entrants"][1]["starts"].contains("play"));
  CHECK(json["entrants"][1]["course"].size() == 3);
  CHECK(json["standings"].size() == 3);
  REQUIRE(json["meetings"].size() == 3);
  CHECK(json["meetings"][2]["a"] == 1);
  CHECK(json["meetings"][2]["b"] == 2);
  CHECK(json["config"]["book"]["kinds"] == nlohmann::json{"kick-off", "play"});
}

TEST_CASE("the JSON of a knock-out has its ties, with null for what is not known", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kKnockOut, {"a", "b", "c"}));
  maker.add({1, 2, 0, 0}, pairOf({3, 1}, {1, 1})).add({0, 1, 1, 0}, std::nullopt);
  const auto json = jsonOf(maker.state());
  CHECK(json["finished"] == false);
  bool bye = false, open = false;
  for (const auto& tie : json["bracket"]) {
    bye |= tie["decided_by"] == "bye" && tie["b"].is_null() && tie["winner"] == 0;
    open |= tie["round"] == 1 && tie["winner"].is_null();
  }
  CHECK(bye);
  CHECK(open);
}

TEST_CASE("the JSON of two teams is that of their series", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"a", "b"}));
  maker.add({0, 1, 0, 0}, pairOf({1, 0}, {1, 0}));
  CHECK(tournamentJson(maker.state(), tableOf(maker.state())) == matchReportJson(maker.state()));
}

TEST_CASE("bytes that are no UTF-8 do not break the JSON", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"a\xff", "b<script>\n"});
  CHECK(jsonOf(maker.state())["entrants"][1]["name"] == "b<script>\n");
}
