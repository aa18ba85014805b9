#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/match.hpp"
#include "tournament/book/book.hpp"
#include "tournament/statistics/sprt.hpp"

namespace fulbito {

/// Who meets whom.
enum class TournamentFormat : std::uint8_t {
  kMatch,       ///< the first entrant against the second
  kGauntlet,    ///< the first entrant against each other
  kRoundRobin,  ///< all against all, in groups if asked for
  kKnockOut,    ///< the loser of a tie leaves; seeding, byes
  kSwiss,       ///< equals meet, nobody twice
  kLadder       ///< neighbours challenge each other for the upper place
};
/// Their names.
inline constexpr std::array<std::string_view, 6> kFormatNames{"match",     "gauntlet", "round-robin",
                                                              "knock-out", "swiss",    "ladder"};
inline constexpr std::size_t kTournamentFormats = kFormatNames.size();
std::string_view nameOf(TournamentFormat format);
/// The format of that name, if any.
std::optional<TournamentFormat> formatOf(std::string_view name);

/// A team of a tournament.
struct Entrant {
  std::string name;  ///< unique in the plan; by default the specification
  TeamChoice team;
  std::vector<std::string> files;  ///< what determines a team outside the program, besides its specification
};

/// Most pairs per meeting of two entrants.
inline constexpr int kMostPairs = 100'000;

/// A tournament: everything that determines its results. A plain value.
struct TournamentPlan {
  std::string name = "tournament";
  TournamentFormat format = TournamentFormat::kRoundRobin;
  std::vector<Entrant> entrants;  ///< in the order of seeding: the strongest first, if known
  int pairs = 1;                  ///< pairs of matches per meeting of two entrants, 1 ... kMostPairs
  int rounds = 0;                 ///< of a Swiss tournament or ladder; 0: as many as the format needs
  int groups = 1;  ///< of a round robin; entrants are dealt to groups in serpentine order of seeding
  /// What all matches share. Teams, start and seed are replaced; `vision` of blue belongs to the first
  /// entrant, that of yellow to all others.
  MatchConfig match;
  std::uint64_t seed = kDefaultMatchSeed;  ///< of the seeds of all pairs
  BookConfig book;                         ///< how matches start
  std::optional<SprtBounds> sprt;          ///< a sequential test ends a tournament of format match
};

/// The pair of entrants in a fixture, and its start.
struct Fixture {
  std::size_t a = 0, b = 0;  ///< indices of the entrants; A plays blue in the first match of the pair
  int round = 0;             ///< from 0
  /// Number of the start, from 0: `BookEntry` and seed of both matches. Each meeting of two entrants goes
  /// through the starts from 0, so that all meetings have the same ones.
  std::size_t start = 0;
};

/// Seed of both matches of a pair with that start. The first start uses the tournament's seed.
std::uint64_t seedOfStart(std::uint64_t seed, std::size_t start);

/// Checks bounds and error rates. Errors: kUsage.
Result<void> validate(const SprtBounds& bounds);

/// Checks names and the test; `validateFormat` and `validate` of the book check the rest. Errors: kUsage.
Result<void> validate(const TournamentPlan& plan);

}  // namespace fulbito
