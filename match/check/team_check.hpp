#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"

/// A check of one team: it plays scripted situations, and recorded calls are told to it again.
namespace fulbito {

/// The verdict of a check, from good to bad.
enum class CheckVerdict : std::uint8_t {
  kOk,       ///< no problem found
  kWarning,  ///< the team may play, but has a disadvantage
  kFailed,   ///< a match punishes this, or results cannot be repeated
};
/// "ok", "warning" or "failed".
const char* nameOf(CheckVerdict verdict);

/// The result of one check.
struct TeamCheck {
  std::string name;  ///< one word, such as "determinism"
  CheckVerdict verdict = CheckVerdict::kOk;
  std::string finding;  ///< one line: what was found, and where
  /// Measured values by name; times [s] begin with `wall_` and differ from run to run.
  std::vector<std::pair<std::string, double>> figures;
};

/// All results of one team.
struct TeamReport {
  std::string team;             ///< its specification
  std::vector<Setting> origin;  ///< version, hash and containment, for a team that is a file or program
  std::uint64_t seed = 0;
  bool quick = false;
  std::vector<TeamCheck> checks;
  /// The worst verdict.
  CheckVerdict verdict() const;
};

/// Called with the finished share of the work. Returning false stops the check.
using CheckProgress = std::function<bool(std::size_t done, std::size_t total)>;

struct TeamCheckOptions {
  TeamChoice team;
  TeamCatalogue catalogue = TeamCatalogue::builtIn();  ///< teams that drills may name as opponents
  std::uint64_t seed = kDefaultMatchSeed;
  bool quick = false;  ///< shorter situations, a third of them repeated, fewer drills and trials
  int jobs = 0;        ///< threads of the drills; 0: one per core
  MatchClock clock;    ///< monotonic time [ns]; required
  CheckProgress progress;
};

/// Checks a team. The results repeat with the seed, if the team is deterministic, except those of time.
/// Errors: kUsage if the team or its navigators cannot be created; kMachine if the machine lacks resources;
/// kInterrupted when `progress` returned false.
Result<TeamReport> checkTeam(const TeamCheckOptions& options);

/// @{ The report as a table to read and as JSON.
std::string teamCheckTable(const TeamReport& report);
std::string teamCheckJson(const TeamReport& report);
/// @}

}  // namespace fulbito
