#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tournament/formats/format.hpp"

namespace fulbito {

/// @{ Each format is defined in the file of its name.
extern const Format kMatchFormat, kGauntletFormat, kRoundRobinFormat, kKnockOutFormat, kSwissFormat,
    kLadderFormat;
/// @}

namespace {

/// In the order of `TournamentFormat`.
constexpr std::array<const Format*, kTournamentFormats> kFormats{
    &kMatchFormat, &kGauntletFormat, &kRoundRobinFormat, &kKnockOutFormat, &kSwissFormat, &kLadderFormat};

constexpr std::int64_t kMostFixtures = 1'000'000;

tl::unexpected<Error> usage(std::string message) { return fail(ErrorCode::kUsage, std::move(message)); }

Result<void> checkEntrants(const TournamentPlan& plan) {
  const std::size_t entrants = plan.entrants.size();
  if (formatOf(plan).most_entrants == 2 && entrants != 2) {
    return usage(fmt::format("entrants: a match has 2, not {}; more need another format", entrants));
  }
  if (entrants < 2) return usage(fmt::format("entrants: want at least 2, not {}", entrants));
  return {};
}

Result<void> checkGroups(const TournamentPlan& plan) {
  if (plan.groups == 1) return {};
  if (!formatOf(plan).has_groups) {
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
  const Format& format = formatOf(plan);
  if (format.rounds == nullptr) {
    return usage(
        fmt::format("rounds: only a Swiss tournament or ladder has rounds to choose, not the format {}",
                    nameOf(plan.format)));
  }
  if (plan.rounds < 0) return usage(fmt::format("rounds: want a positive number, not {}", plan.rounds));
  const std::size_t most = plan.entrants.size() - 1;
  if (format.meets_once && static_cast<std::size_t>(plan.rounds) > most) {
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
  if (!plan.sprt || formatOf(plan).has_test) return {};
  return usage(fmt::format("sprt: only the format match has a sequential test, not the format {}",
                           nameOf(plan.format)));
}

}  // namespace

const Format& formatOf(const TournamentPlan& plan) {
  return *kFormats[static_cast<std::size_t>(plan.format)];
}

Schedule scheduleOf(const TournamentPlan& plan, const FixtureResults& results) {
  return formatOf(plan).schedule(plan, results);
}

int roundsOf(const TournamentPlan& plan) {
  return plan.rounds > 0 ? plan.rounds : formatOf(plan).rounds(plan.entrants.size());
}

std::int64_t mostFixtures(const TournamentPlan& plan) { return formatOf(plan).most_fixtures(plan); }

std::int64_t mostOfRounds(const TournamentPlan& plan) {
  return roundsOf(plan) * (static_cast<std::int64_t>(plan.entrants.size()) / 2) * plan.pairs;
}

std::vector<Standing> standingsOf(const TournamentPlan& plan, const Schedule& schedule,
                                  const FixtureResults& results, std::size_t counted) {
  const std::size_t known = std::min({counted, results.size(), schedule.fixtures.size()});
  return formatOf(plan).table({plan, schedule.fixtures, ResultsView(results).first(known)});
}

Result<void> validateFormat(const TournamentPlan& plan) {
  for (const auto check : {checkEntrants, checkGroups, checkRounds, checkPairs, checkTest}) {
    if (auto checked = check(plan); !checked) return checked;
  }
  return {};
}

}  // namespace fulbito
