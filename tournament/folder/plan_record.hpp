#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tournament/formats/schedule.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/plan/plan.hpp"

namespace fulbito {

/// A plan with the identities of its teams, as a tournament's folder keeps it. Reports need nothing else: the
/// teams and presets need not exist any more.
struct PlanRecord {
  TournamentPlan plan;  ///< read back: entrants have names and specifications, but no team that can play
  MatchIdentity identity;
};

/// The record as JSON (docs/results-format.md), with a line end.
std::string toJson(const PlanRecord& record);

/// Reads `toJson` back. Errors: kBadInput with `origin`.
Result<PlanRecord> parsePlanRecord(std::string_view text, const std::string& origin);

/// What differs between two plans, for people: "pairs: 2 -> 5". Identities of teams are no part of a plan.
std::vector<std::string> changesOf(const TournamentPlan& before, const TournamentPlan& after);

/// What differs between the identities of two records of one plan: "libero has changed", "the engine has
/// changed". Matches that depend on it are played again.
std::vector<std::string> changesOf(const PlanRecord& before, const PlanRecord& after);

}  // namespace fulbito
