#include "tournament/folder/plan_record.hpp"

#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

PlanRecord recordOf() {
  TournamentPlan plan;
  plan.name = "spring";
  plan.format = TournamentFormat::kSwiss;
  plan.entrants = {{"a", *parseTeam("chaser"), {"x.bin"}}, {"b", *parseTeam("classic:navigator=bezier"), {}}};
  plan.pairs = 3;
  plan.rounds = 1;
  plan.seed = (std::uint64_t{1} << 53) - 1;
  plan.book = {{StartKind::kPlay, StartKind::kKickOff}, 9};
  plan.match = shortMatch("chaser", "chaser", 12.5);
  plan.match.vision[1].latency_ticks = 4;
  plan.match.decision_time = DecisionTime{std::numeric_limits<double>::infinity(), 2.0, 30, 10.0, 3};
  std::vector<TeamIdentity> teams(2);
  teams[0].hash = "one";
  teams[1].hash = "two";
  teams[1].outside = true;
  teams[1].deterministic = false;
  return {plan, *MatchIdentity::restore(plan, "engine", "0123456789abcdef0123456789abcdef", teams)};
}

}  // namespace

TEST_CASE("a plan reads back with the same matches", "[unit]") {
  const PlanRecord record = recordOf();
  const auto read = parsePlanRecord(toJson(record), "plan.json");
  REQUIRE(read);
  CHECK(changesOf(record.plan, read->plan).empty());
  CHECK(changesOf(record, *read).empty());
  CHECK(toJson(*read) == toJson(record));
  for (std::size_t start = 0; start < 5; ++start) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      CHECK(read->identity.of({0, 1, 0, start}, leg) == record.identity.of({0, 1, 0, start}, leg));
    }
  }
}

TEST_CASE("what differs between plans is named", "[unit]") {
  const PlanRecord before = recordOf();
  PlanRecord after = before;
  after.plan.pairs = 5;
  after.plan.entrants[1].team = *parseTeam("libero");
  after.plan.match.rules.half_seconds = 30.0;
  const std::vector<std::string> changes = changesOf(before.plan, after.plan);
  REQUIRE(changes.size() == 3);
  CHECK(changes[0] == "entrants.2.team: classic:navigator=bezier -> libero");
  CHECK(changes[1] == "match.rules [periods] half_seconds: 12.5 -> 30.0");
  CHECK(changes[2] == "pairs: 3 -> 5");
  std::vector<TeamIdentity> teams = before.identity.teams();
  teams[1].hash = "three";
  after.identity =
      *MatchIdentity::restore(after.plan, "other engine", "0123456789abcdef0123456789abcdef", teams);
  CHECK(changesOf(before, after) == std::vector<std::string>{"the engine has changed", "b has changed"});
}

TEST_CASE("what is no plan is refused with the file's name", "[unit]") {
  const std::string good = toJson(recordOf());
  for (std::size_t size : {std::size_t{0}, std::size_t{1}, good.size() / 2, good.size() - 3}) {
    const auto read = parsePlanRecord(good.substr(0, size), "plan.json");
    REQUIRE_FALSE(read);
    CHECK(read.error().code == ErrorCode::kBadInput);
    CHECK(read.error().message.find("plan.json") == 0);
  }
  for (const auto& [from, to] :
       {std::pair{"\"swiss\"", "\"league\""}, std::pair{"\"pairs\": 3", "\"pairs\": 0"},
        std::pair{"\"pairs\": 3", "\"pairs\": \"x\""}, std::pair{"\"b\"", "\"a\""},
        std::pair{"0123456789abcdef", "0123456789ABCDEF"}}) {
    std::string text = good;
    text.replace(text.find(from), std::string(from).size(), to);
    INFO(to);
    CHECK_FALSE(parsePlanRecord(text, "plan.json"));
  }
}

}  // namespace fulbito
