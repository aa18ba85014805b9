#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {

TEST_CASE("a standard match can be played as it is", "[unit]") {
  const auto config = MatchConfig::standard("libero", "classic");
  REQUIRE(config);
  auto match = Match::create(*config);
  REQUIRE(match);
  CHECK(match->step());
  CHECK(match->ids().size() == 6);
}

TEST_CASE("a standard match takes settings of teams and other rules", "[unit]") {
  const auto config = MatchConfig::standard("classic:navigator=bezier", "idle", "vsss-5v5");
  REQUIRE(config);
  CHECK(config->teams[0].text == "classic:navigator=bezier");
  CHECK(config->rules.team_size == 5);
  CHECK(config->field.name == config->rules.field);
  CHECK(Match::create(*config));
}

TEST_CASE("a standard match says what is wrong with the names it is given", "[unit]") {
  const auto team = MatchConfig::standard("libero", "clasic");
  REQUIRE_FALSE(team);
  CHECK(team.error().code == ErrorCode::kUsage);
  CHECK(team.error().message.find("classic") != std::string::npos);
  const auto rules = MatchConfig::standard("libero", "classic", "vsss-3v4");
  REQUIRE_FALSE(rules);
  CHECK(rules.error().message.find("vsss-3v3") != std::string::npos);
}

}  // namespace fulbito::test
