#include "tournament/formats/schedule.hpp"

#include "tournament/formats/fixed_formats.hpp"
#include "tournament/formats/knock_out.hpp"
#include "tournament/formats/ladder.hpp"
#include "tournament/formats/swiss.hpp"

namespace fulbito {
namespace {

/// The smallest k with 2^k >= n: so many rounds leave one winner of n.
int roundsToOne(std::size_t n) {
  int rounds = 0;
  while ((std::size_t{1} << rounds) < n) ++rounds;
  return rounds;
}

/// Meetings of a round robin in groups.
std::int64_t roundRobinMeetings(const TournamentPlan& plan) {
  std::int64_t meetings = 0;
  for (const auto& group : groupsOf(plan)) {
    const auto size = static_cast<std::int64_t>(group.size());
    meetings += size * (size - 1) / 2;
  }
  return meetings;
}

}  // namespace

Schedule scheduleOf(const TournamentPlan& plan, const FixtureResults& results) {
  switch (plan.format) {
    case TournamentFormat::kMatch:
    case TournamentFormat::kGauntlet:
      return gauntletSchedule(plan);
    case TournamentFormat::kRoundRobin:
      return roundRobinSchedule(plan);
    case TournamentFormat::kKnockOut:
      return knockOutCourse(plan, results).schedule;
    case TournamentFormat::kSwiss:
      return swissSchedule(plan, results);
    case TournamentFormat::kLadder:
      return ladderCourse(plan, results).schedule;
  }
  return {};
}

int roundsOf(const TournamentPlan& plan) {
  if (plan.rounds > 0) return plan.rounds;
  // A ladder of n: neighbours that change places in alternate pairs sort any order of n in n rounds.
  return plan.format == TournamentFormat::kLadder ? static_cast<int>(plan.entrants.size())
                                                  : roundsToOne(plan.entrants.size());
}

std::int64_t mostFixtures(const TournamentPlan& plan) {
  const auto entrants = static_cast<std::int64_t>(plan.entrants.size());
  const std::int64_t pairs = plan.pairs;
  switch (plan.format) {
    case TournamentFormat::kMatch:
    case TournamentFormat::kGauntlet:
      return (entrants - 1) * pairs;
    case TournamentFormat::kRoundRobin:
      return roundRobinMeetings(plan) * pairs;
    case TournamentFormat::kKnockOut:
      return knockOutTies(plan.entrants.size()) * (pairs + kMostExtraPairs);
    case TournamentFormat::kSwiss:
    case TournamentFormat::kLadder:
      return roundsOf(plan) * (entrants / 2) * pairs;
  }
  return 0;
}

}  // namespace fulbito
