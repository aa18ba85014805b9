#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "tournament/results/results.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito::test {

/// A match with values of its own for each number: equal numbers give equal rows.
inline MatchRow matchRow(std::uint64_t number) {
  MatchRow row;
  // An odd factor gives different numbers different identities, spread as hashes are.
  row.id.words = {number * 0x9e3779b97f4a7c15u, ~number};
  row.teams = {"classic", number % 3 == 0 ? "chaser" : "libero"};
  row.start = fmt::format("free-ball:{}", number % 40);
  row.seed = 0xffffffffffffffffu - number;
  row.result.score = {static_cast<int>(number % 5), static_cast<int>(number % 7)};
  if (number % 4 != 0) row.result.winner = kTeams[number % 2];
  row.result.goals_after_foul = {static_cast<int>(number % 2), 0};
  row.result.play = {static_cast<Tick>(18000 + number % 1000), static_cast<Tick>(number % 7000), 5, {}};
  for (TeamRecord& team : row.result.play.teams) {
    for (const auto count : kPlayCounts) team.*count = static_cast<Tick>(1 + number % 20000);
  }
  row.result.ticks = static_cast<Tick>(18000 + number);
  row.result.hash = number * 0xbf58476d1ce4e5b9u;
  row.result.outcome = static_cast<MatchOutcome>(number % 6);
  row.result.faults.teams[0].saturated = static_cast<std::int64_t>(number % 1000);
  row.result.faults.teams[1].saturated = static_cast<std::int64_t>(number % 900);
  return row;
}

/// The text of a log with the matches 0 ... count - 1.
inline std::string logText(std::uint64_t count) {
  std::string text(logHeader());
  for (std::uint64_t i = 0; i < count; ++i) text += toLine(matchRow(i));
  return text;
}

}  // namespace fulbito::test
