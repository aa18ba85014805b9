#include "tournament/tune/tune_plan.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"

namespace fulbito {
namespace {

constexpr int kFinal = 0;  // number of the final match-ups in place of an iteration's

std::uint64_t seedOf(const TunePlan& plan, int iteration) {
  // 53 bits, so that JSON readers can hold it as a double.
  return Rng(plan.base.seed, Stream::kTuneStarts, static_cast<std::uint64_t>(iteration)).bits64() >> 11;
}

/// The base plan with the starts of an iteration. Kinds of starts continue where the last iteration ended.
TournamentPlan onStarts(const TunePlan& plan, int iteration) {
  TournamentPlan own = plan.base;
  own.entrants.clear();
  own.seed = seedOf(plan, iteration);
  own.book.seed ^= own.seed;
  auto& kinds = own.book.kinds;
  const auto before =
      static_cast<std::size_t>(std::max(iteration - 1, 0)) * static_cast<std::size_t>(own.pairs);
  std::rotate(kinds.begin(), kinds.begin() + static_cast<std::ptrdiff_t>(before % kinds.size()), kinds.end());
  return own;
}

/// @{ Vision by seat of the base plan. Both versions have the vision of the team.
const VisionModel& sightOfTeam(const TunePlan& plan) { return plan.base.match.vision[0]; }
const VisionModel& sightOfOpponent(const TunePlan& plan) { return plan.base.match.vision[1]; }
/// @}

Result<void> addVersion(const TunePlan& plan, const TeamCatalogue& teams, const TunePoint& point,
                        const char* name, TournamentPlan& own) {
  auto team = teams.parse(plan.team.at(plan.spsa.parameters, point));
  if (!team) return tl::unexpected<Error>(team.error());
  own.entrants.push_back({name, std::move(*team), plan.base.entrants[0].files});
  return {};
}

void addEntrant(const Entrant& entrant, const char* name, TournamentPlan& own) {
  own.entrants.push_back(entrant);
  own.entrants.back().name = name;
}

}  // namespace

Result<void> validate(const TunePlan& plan) {
  if (auto checked = validate(plan.spsa); !checked) return checked;
  if (plan.final_pairs < 0 || plan.final_pairs > kMostPairs) {
    return fail(ErrorCode::kUsage,
                fmt::format("--final-pairs: {} is outside 0 ... {}", plan.final_pairs, kMostPairs));
  }
  return {};
}

Result<TournamentPlan> iterationPlan(const TunePlan& plan, const TeamCatalogue& teams, const TunePoint& point,
                                     int iteration) {
  TournamentPlan own = onStarts(plan, iteration);
  own.name = fmt::format("iteration {}", iteration);
  own.match.vision = {sightOfTeam(plan), sightOfTeam(plan)};
  if (plan.opponent) {
    own.format = TournamentFormat::kGauntlet;
    own.match.vision = {sightOfOpponent(plan), sightOfTeam(plan)};
    addEntrant(plan.base.entrants[1], "opponent", own);
  }
  const TunePair versions = versionsAt(plan.spsa, point, iteration);
  for (const auto& added : {addVersion(plan, teams, versions.plus, "plus", own),
                            addVersion(plan, teams, versions.minus, "minus", own)}) {
    if (!added) return tl::unexpected<Error>(added.error());
  }
  return own;
}

double iterationResult(const TunePlan& plan, const Schedule& schedule, ResultsView results) {
  double sum = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double points = results[i]->points();
    if (!plan.opponent) {
      sum += 2.0 * points - 1.0;
    } else {  // the opponent is first: the version loses the points that the opponent wins
      sum += schedule.fixtures[i].b == 1 ? -points : points;
    }
  }
  return sum / plan.base.pairs;
}

Result<std::vector<FinalPlan>> finalPlans(const TunePlan& plan, const TeamCatalogue& teams,
                                          const TunePoint& point) {
  std::vector<FinalPlan> finals;
  if (plan.final_pairs == 0) return finals;
  const auto add = [&](const char* first, const char* second) -> Result<void> {
    TournamentPlan own = onStarts(plan, kFinal);
    own.name = fmt::format("{} against {}", first, second);
    own.pairs = plan.final_pairs;
    const bool outside = second == std::string_view("opponent");
    own.match.vision = {sightOfTeam(plan), outside ? sightOfOpponent(plan) : sightOfTeam(plan)};
    if (first == std::string_view("tuned")) {
      if (auto added = addVersion(plan, teams, point, first, own); !added) return added;
    } else {
      addEntrant(plan.base.entrants[0], first, own);
    }
    addEntrant(plan.base.entrants[outside ? 1 : 0], second, own);
    finals.push_back({first, second, std::move(own)});
    return {};
  };
  if (auto added = add("tuned", "start"); !added) return tl::unexpected<Error>(added.error());
  if (!plan.opponent) return finals;
  for (const char* first : {"tuned", "start"}) {
    if (auto added = add(first, "opponent"); !added) return tl::unexpected<Error>(added.error());
  }
  return finals;
}

}  // namespace fulbito
