#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tournament/formats/schedule.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/plan/plan.hpp"

namespace fulbito {

/// A plan with the identities of its teams, as stored in a tournament's folder. Reports read nothing else, so
/// they work even if teams and presets have been deleted.
struct PlanRecord {
  /// If read from a file, entrants have names and specifications, but no team that can play.
  TournamentPlan plan;
  MatchIdentity identity;
};

/// The record as JSON (docs/results-format.md), with a line end.
std::string toJson(const PlanRecord& record);

/// Parses what `toJson` writes. Errors: kBadInput with `origin`.
Result<PlanRecord> parsePlanRecord(std::string_view text, const std::string& origin);

/// The differences between two plans, for people: "pairs: 2 -> 5". Team identities are not compared.
std::vector<std::string> changesOf(const TournamentPlan& before, const TournamentPlan& after);

/// The differences between the identities of two records of one plan: "libero has changed", "the engine has
/// changed". Matches that depend on a changed identity are played again.
std::vector<std::string> changesOf(const PlanRecord& before, const PlanRecord& after);

}  // namespace fulbito
