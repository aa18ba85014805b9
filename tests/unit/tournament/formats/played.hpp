#pragma once

#include <functional>
#include <string>

#include "engine/core/math/random.hpp"
#include "tournament/formats/standings.hpp"

namespace fulbito::test {

/// A plan of entrants "e0", "e1" ...
TournamentPlan planOf(TournamentFormat format, std::size_t entrants, int pairs = 1);

/// A pair with these goals of A and B in both matches.
PairResult pairOf(int a0, int b0, int a1, int b1);

/// The result of a fixture: pure, so that the order of play cannot change it.
using Play = std::function<PairResult(const Fixture&)>;

/// Random goals from seed and fixture: few or many draws, and shoot-outs.
Play randomPlay(std::uint64_t seed);
/// The entrant that ranks first by `before` wins each match by one goal.
Play orderedPlay(std::function<bool(std::size_t, std::size_t)> before);

struct Played {
  Schedule schedule;
  FixtureResults results;
};

/// Plays to the end, always the first missing fixture.
Played playInOrder(const TournamentPlan& plan, const Play& play);

/// Plays to the end, in each step some of the missing fixtures. Checks that schedules only grow.
Played playInDisorder(const TournamentPlan& plan, const Play& play, Rng& rng);

/// Entrants of a table in order, such as "2 0 1", with "=" before one that shares the rank above.
std::string orderOf(const std::vector<Standing>& table);

bool sameSchedule(const Schedule& a, const Schedule& b);

}  // namespace fulbito::test
