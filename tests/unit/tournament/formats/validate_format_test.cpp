#include <tuple>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/formats/played.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

void checkRefused(const TournamentPlan& plan, const std::string& key) {
  const auto checked = validateFormat(plan);
  REQUIRE_FALSE(checked);
  CHECK(checked.error().code == ErrorCode::kUsage);
  CAPTURE(checked.error().message);
  CHECK(checked.error().message.starts_with(key + ": "));
}

}  // namespace

TEST_CASE("plans of all formats with two to forty entrants are accepted", "[unit]") {
  for (std::size_t f = 1; f < kTournamentFormats; ++f) {
    const auto format = static_cast<TournamentFormat>(f);
    for (std::size_t entrants = 2; entrants <= 40; ++entrants)
      CHECK(validateFormat(planOf(format, entrants)));
  }
  TournamentPlan match = planOf(TournamentFormat::kMatch, 2, 100000);
  match.sprt = SprtBounds{};
  CHECK(validateFormat(match));
}

TEST_CASE("numbers of entrants that a format cannot have are refused", "[unit]") {
  for (const std::size_t entrants : {0u, 1u, 3u})
    checkRefused(planOf(TournamentFormat::kMatch, entrants), "entrants");
  for (const auto format :
       {TournamentFormat::kGauntlet, TournamentFormat::kKnockOut, TournamentFormat::kSwiss}) {
    checkRefused(planOf(format, 0), "entrants");
    checkRefused(planOf(format, 1), "entrants");
  }
}

TEST_CASE("pairs, rounds and groups out of range name their key", "[unit]") {
  for (const int pairs : {-1, 0, 100001}) checkRefused(planOf(TournamentFormat::kMatch, 2, pairs), "pairs");
  checkRefused(planOf(TournamentFormat::kRoundRobin, 100, 1000), "pairs");  // 4,950,000 pairs in all
  for (const auto& [format, entrants, rounds, groups, key] :
       {std::tuple{TournamentFormat::kSwiss, 8u, 8, 1, "rounds"},
        std::tuple{TournamentFormat::kSwiss, 8u, -1, 1, "rounds"},
        std::tuple{TournamentFormat::kLadder, 8u, -1, 1, "rounds"},
        std::tuple{TournamentFormat::kLadder, 8u, 2147483647, 1, "pairs"},
        std::tuple{TournamentFormat::kRoundRobin, 8u, 3, 1, "rounds"},
        std::tuple{TournamentFormat::kKnockOut, 8u, 3, 1, "rounds"},
        std::tuple{TournamentFormat::kRoundRobin, 8u, 0, 0, "groups"},
        std::tuple{TournamentFormat::kRoundRobin, 8u, 0, -2, "groups"},
        std::tuple{TournamentFormat::kRoundRobin, 7u, 0, 4, "groups"},
        std::tuple{TournamentFormat::kSwiss, 8u, 0, 2, "groups"}}) {
    TournamentPlan plan = planOf(format, entrants);
    plan.rounds = rounds;
    plan.groups = groups;
    checkRefused(plan, key);
  }
}

TEST_CASE("a sequential test belongs to a match", "[unit]") {
  TournamentPlan plan = planOf(TournamentFormat::kGauntlet, 2);
  plan.sprt = SprtBounds{};
  checkRefused(plan, "sprt");
}
