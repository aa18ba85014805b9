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

/// The formats of a tournament: who meets whom.
enum class TournamentFormat : std::uint8_t {
  kMatch,       ///< the first entrant against the second
  kGauntlet,    ///< the first entrant against each other
  kRoundRobin,  ///< everyone meets everyone, in groups if the plan asks for them
  kKnockOut,    ///< the loser of a tie leaves; with seeding and byes
  kSwiss,       ///< entrants with similar points meet, nobody twice
  kLadder       ///< neighbours on the ladder play for the upper place
};
/// Names of the formats, in the order of `TournamentFormat`.
inline constexpr std::array<std::string_view, 6> kFormatNames{"match",     "gauntlet", "round-robin",
                                                              "knock-out", "swiss",    "ladder"};
inline constexpr std::size_t kTournamentFormats = kFormatNames.size();
std::string_view nameOf(TournamentFormat format);
/// The format with this name, if any.
std::optional<TournamentFormat> formatOf(std::string_view name);

/// One team that takes part in a tournament.
struct Entrant {
  std::string name;  ///< unique in the plan; by default the specification
  TeamChoice team;
  /// Files outside the program that determine the team, besides its specification.
  std::vector<std::string> files;
};

/// Largest number of pairs per meeting of two entrants.
inline constexpr int kMostPairs = 100'000;

/// Everything that determines the results of a tournament.
struct TournamentPlan {
  std::string name = "tournament";
  TournamentFormat format = TournamentFormat::kRoundRobin;
  std::vector<Entrant> entrants;  ///< in the order of seeding: the strongest first, if known
  int pairs = 1;                  ///< pairs of matches per meeting of two entrants, 1 ... kMostPairs
  int rounds = 0;                 ///< rounds of a Swiss tournament or ladder; 0: as many as the format needs
  int groups = 1;  ///< groups of a round robin; entrants are dealt to them in serpentine order of seeding
  /// The configuration that all matches share. Teams, start and seed are replaced. Blue's `vision` applies to
  /// the first entrant, yellow's to all others.
  MatchConfig match;
  std::uint64_t seed = kDefaultMatchSeed;  ///< seed that the seeds of all pairs derive from
  BookConfig book;                         ///< the starts of matches
  std::optional<SprtBounds> sprt;          ///< sequential test that ends a tournament of format match
};

/// Two entrants who play a pair of matches, and the start of that pair.
struct Fixture {
  std::size_t a = 0, b = 0;  ///< indices of the entrants; A plays blue in the first match of the pair
  int round = 0;             ///< number of the round, from 0
  /// Number of the start, from 0: it selects the `BookEntry` and the seed of both matches. Each meeting of
  /// two entrants counts starts from 0, so all meetings have the same ones.
  std::size_t start = 0;
};

/// Seed of both matches of a pair with this start. Start 0 uses the tournament's seed itself.
std::uint64_t seedOfStart(std::uint64_t seed, std::size_t start);

/// Checks bounds and error rates. Errors: kUsage.
Result<void> validate(const SprtBounds& bounds);

/// Checks names and the sequential test. `validateFormat` and the book's `validate` check the rest. Errors:
/// kUsage.
Result<void> validate(const TournamentPlan& plan);

}  // namespace fulbito
