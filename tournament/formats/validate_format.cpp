#include <fmt/format.h>

#include "tournament/formats/schedule.hpp"

namespace fulbito {
namespace {

constexpr std::int64_t kMostFixtures = 1'000'000;

tl::unexpected<Error> usage(std::string message) { return fail(ErrorCode::kUsage, std::move(message)); }

Result<void> checkEntrants(const TournamentPlan& plan) {
  const std::size_t entrants = plan.entrants.size();
  if (plan.format == TournamentFormat::kMatch && entrants != 2) {
    return usage(fmt::format("entrants: a match has 2, not {}; more need another format", entrants));
  }
  if (entrants < 2) return usage(fmt::format("entrants: want at least 2, not {}", entrants));
  return {};
}

Result<void> checkGroups(const TournamentPlan& plan) {
  if (plan.groups == 1) return {};
  if (plan.format != TournamentFormat::kRoundRobin) {
    return usage(
        fmt::format("groups: only a round robin has groups, not the format {}", nameOf(plan.format)));
  }
  const std::size_t most = plan.entrants.size() / 2;
  if (plan.groups < 1 || static_cast<std::size_t>(plan.groups) > most) {
    return usage(fmt::format("groups: want 1 ... {} for {} entrants, so that each has at least 2, not {}",
                             most, plan.entrants.size(), plan.groups));
  }
  return {};
}

Result<void> checkRounds(const TournamentPlan& plan) {
  if (plan.rounds == 0) return {};
  const bool swiss = plan.format == TournamentFormat::kSwiss;
  if (!swiss && plan.format != TournamentFormat::kLadder) {
    return usage(
        fmt::format("rounds: only a Swiss tournament or ladder has rounds to choose, not the format {}",
                    nameOf(plan.format)));
  }
  if (plan.rounds < 0) return usage(fmt::format("rounds: want a positive number, not {}", plan.rounds));
  const std::size_t most = plan.entrants.size() - 1;
  if (swiss && static_cast<std::size_t>(plan.rounds) > most) {
    return usage(fmt::format("rounds: {} entrants meet nobody twice in at most {} rounds, not {}",
                             plan.entrants.size(), most, plan.rounds));
  }
  return {};
}

Result<void> checkPairs(const TournamentPlan& plan) {
  if (plan.pairs < 1 || plan.pairs > kMostPairs) {
    return usage(fmt::format("pairs: {} is outside 1 ... {}", plan.pairs, kMostPairs));
  }
  if (const std::int64_t fixtures = mostFixtures(plan); fixtures > kMostFixtures) {
    return usage(fmt::format("pairs: {} per meeting make up to {} in all; want at most {}", plan.pairs,
                             fixtures, kMostFixtures));
  }
  return {};
}

Result<void> checkTest(const TournamentPlan& plan) {
  if (!plan.sprt || plan.format == TournamentFormat::kMatch) return {};
  return usage(fmt::format("sprt: only the format match has a sequential test, not the format {}",
                           nameOf(plan.format)));
}

}  // namespace

Result<void> validateFormat(const TournamentPlan& plan) {
  for (const auto check : {checkEntrants, checkGroups, checkRounds, checkPairs, checkTest}) {
    if (auto checked = check(plan); !checked) return checked;
  }
  return {};
}

}  // namespace fulbito
