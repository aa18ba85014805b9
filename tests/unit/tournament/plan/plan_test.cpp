#include "tournament/plan/plan.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("names of formats read back", "[unit]") {
  for (std::size_t i = 0; i < kTournamentFormats; ++i) {
    const auto format = static_cast<TournamentFormat>(i);
    CHECK(formatOf(nameOf(format)) == format);
  }
  CHECK_FALSE(formatOf("league"));
}

TEST_CASE("entrants have names of their own", "[unit]") {
  TournamentPlan plan;
  plan.entrants = {{"a", {}, {}}, {"a", {}, {}}};
  CHECK(validate(plan).error().message == "two entrants are named 'a'; give one another name");
  plan.entrants[1].name = "";
  CHECK(validate(plan).error().message == "the name of an entrant must have 1 ... 200 bytes");
  plan.entrants[1].name = std::string(201, 'x');
  CHECK_FALSE(validate(plan));
  plan.entrants[1].name = "b";
  CHECK(validate(plan));
}

}  // namespace fulbito
