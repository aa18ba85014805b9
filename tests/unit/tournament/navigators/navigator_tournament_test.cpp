#include "tournament/navigators/navigator_tournament.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"

using namespace fulbito;
using Catch::Matchers::Contains;

namespace {

NavigatorTournamentConfig small() {
  NavigatorTournamentConfig config;
  config.suite = "corner";
  config.navigators = {"straight", "bezier", "dwa"};
  config.trials = 6;
  config.jobs = 1;
  return config;
}

std::string errorOf(const NavigatorTournamentConfig& config) {
  const auto plan = planNavigatorTournament(config);
  REQUIRE_FALSE(plan);
  CHECK(plan.error().code == ErrorCode::kUsage);
  return plan.error().message;
}

}  // namespace

TEST_CASE("a tournament of navigators gives the same bytes on any number of threads", "[unit]") {
  NavigatorTournamentConfig config = small();
  const auto one = runNavigatorTournament(config, {});
  config.jobs = 2;
  const auto two = runNavigatorTournament(config, {});
  REQUIRE(one);
  REQUIRE(two);
  CHECK(navigatorTournamentText(*one) == navigatorTournamentText(*two));
  CHECK(navigatorTournamentJson(*one) == navigatorTournamentJson(*two));
}

TEST_CASE("its figures are those of the comparison of the same layouts", "[unit]") {
  NavigatorTournamentConfig config = small();
  config.speed = 1.0;
  const auto tournament = runNavigatorTournament(config, {});
  REQUIRE(tournament);
  for (const NavigatorStanding& row : tournament->table.standings) {
    CHECK(row.arrived.value == tournament->comparison.summary[row.navigator].success.value);
    CHECK(row.won + row.drawn + row.lost == 2 * 6);
  }
  CHECK(tournament->tie == tournament->comparison.physics.controlPeriod());
}

TEST_CASE("the reports name all navigators and the table's figures", "[unit]") {
  const auto tournament = runNavigatorTournament(small(), {});
  REQUIRE(tournament);
  const auto json = nlohmann::json::parse(navigatorTournamentJson(*tournament));
  CHECK(json["schema_version"] == 1);
  CHECK(json["layouts"] == 6);
  REQUIRE(json["standings"].size() == 3);
  REQUIRE(json["meetings"].size() == 3);
  const NavigatorStanding& best = tournament->table.standings.front();
  CHECK(json["standings"][0]["rank"] == 1);
  CHECK(json["standings"][0]["elo"]["value"].get<double>() == best.elo.value);
  CHECK(json["meetings"][0]["first"] == json["standings"][0]["navigator"]);
  const std::string text = navigatorTournamentText(*tournament);
  for (const char* part : {"straight", "bezier", "dwa", "6 layouts", "p (Holm)", "bezier v"}) {
    CHECK_THAT(text, Contains(part));
  }
}

TEST_CASE("a tournament that cannot be played is refused", "[unit]") {
  NavigatorTournamentConfig config = small();
  config.navigators = {"bezier"};
  CHECK_THAT(errorOf(config), Contains("at least two"));
  config.navigators = {"bezier", "dwa", "bezier"};
  CHECK_THAT(errorOf(config), Contains("'bezier' is named twice"));
  config.navigators = {"bezier", "beizer"};
  CHECK_THAT(errorOf(config), Contains("beizer"));
  config = small();
  config.suite = "jung-lee-2015";
  CHECK_THAT(errorOf(config), Contains("--suite"));
  config.suite = "cornr";
  CHECK_THAT(errorOf(config), Contains("cornr"));
  config = small();
  config.speed = 0.0;
  CHECK_THAT(errorOf(config), Contains("--speed: 0"));
  config = small();
  config.trials = -1;
  CHECK_THAT(errorOf(config), Contains("--trials"));
}

TEST_CASE("a stopped tournament has no table", "[unit]") {
  const auto stopped =
      runNavigatorTournament(small(), [](std::size_t done, std::size_t) { return done < 2; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}
