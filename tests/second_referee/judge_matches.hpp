#pragma once

#include "fulbito/match.hpp"
#include "tests/second_referee/second_referee.hpp"

namespace fulbito::second {

/// What came of many matches.
struct Verdict {
  int matches = 0;
  std::map<std::string, Tally> tallies;
  std::vector<std::string> disagreements;  ///< each with the match that it is of

  int calls() const;
};

/// Profiles that the built-in teams are judged by: the four of the program; the book's with pushing and
/// pinning called as well, which no profile of the program calls; and with a shoot-out after a draw. The last
/// two wait before each signal.
std::vector<Rules> judgedRules();

/// A match of two built-in teams with `vsss` robots on `standard` physics. Throws what is wrong.
Match matchOf(const std::string& blue, const std::string& yellow, const Rules& rules, double half_seconds,
              std::uint64_t seed);

/// The same of any two teams.
Match matchOf(PerTeam<TeamChoice> teams, const Rules& rules, double half_seconds, std::uint64_t seed);

/// Plays match number `index`, counted from 0, and adds to the verdict: match by match all pairings of the
/// built-in teams; after each round of them the next profile. The match's seed is `first_seed + index`.
void judgeMatch(int index, double half_seconds, std::uint64_t first_seed, Verdict& verdict);

}  // namespace fulbito::second
