#pragma once

#include <functional>
#include <string>

#include "engine/core/math/random.hpp"
#include "tournament/formats/standings.hpp"

namespace fulbito::test {

/// A plan with entrants "e0", "e1" ...
TournamentPlan planOf(TournamentFormat format, std::size_t entrants, int pairs = 1);

/// A pair with these goals of A and B in the first and in the second match.
PairResult pairOf(int a0, int b0, int a1, int b1);

/// Returns the result of a fixture. It depends only on the fixture, not on the order of play.
using Play = std::function<PairResult(const Fixture&)>;

/// Random goals drawn from seed and fixture. The seed decides on few or many draws and on shoot-outs.
Play randomPlay(std::uint64_t seed);
/// The entrant that ranks first by `before` wins each match by one goal.
Play orderedPlay(std::function<bool(std::size_t, std::size_t)> before);

struct Played {
  Schedule schedule;
  FixtureResults results;
};

/// Plays a tournament to its end, always the first fixture without a result.
Played playInOrder(const TournamentPlan& plan, const Play& play);

/// Plays a tournament to its end, in each step some of the fixtures without results. Checks that schedules
/// only grow.
Played playInDisorder(const TournamentPlan& plan, const Play& play, Rng& rng);

/// The entrants of a table in order, such as "2 0 1", with "=" before one that shares the rank above it.
std::string orderOf(const std::vector<Standing>& table);

bool sameSchedule(const Schedule& a, const Schedule& b);

}  // namespace fulbito::test
