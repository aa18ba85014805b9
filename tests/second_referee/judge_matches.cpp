#include "tests/second_referee/judge_matches.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace fulbito::second {
namespace {

struct Pairing {
  std::string blue, yellow;
};

/// Each with each, and with itself: those of different teams in the order that gives each its turn as blue.
std::vector<Pairing> pairings() {
  std::vector<Pairing> all;
  const auto teams = TeamCatalogue::builtIn().teams();
  for (std::size_t a = 0; a < teams.size(); ++a) {
    for (std::size_t b = a; b < teams.size(); ++b) {
      const bool swap = (a + b) % 2 == 1;
      all.push_back({teams[swap ? b : a]->name, teams[swap ? a : b]->name});
    }
  }
  return all;
}

template <typename T>
T need(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

}  // namespace

Match matchOf(const std::string& blue, const std::string& yellow, const Rules& rules, double half_seconds,
              std::uint64_t seed) {
  return matchOf({need(parseTeam(blue)), need(parseTeam(yellow))}, rules, half_seconds, seed);
}

Match matchOf(PerTeam<TeamChoice> teams, const Rules& rules, double half_seconds, std::uint64_t seed) {
  MatchConfig config;
  config.teams = std::move(teams);
  config.rules = rules;
  config.rules.half_seconds = half_seconds;
  config.field = need(loadField(rules.field));
  config.robot = need(loadRobot("vsss"));
  config.physics = need(loadPhysics("standard"));
  config.seed = seed;
  return need(Match::create(config));
}

int Verdict::calls() const {
  int calls = 0;
  for (const auto& [clause, tally] : tallies) calls += tally.both;
  return calls;
}

std::vector<Rules> judgedRules() {
  std::vector<Rules> all;
  for (const char* name : {"vsss-3v3", "league-program-2021", "vsss-5v5", "training", "vsss-3v3"}) {
    all.push_back(need(loadRules(name)));
  }
  Rules& strict = all.back();
  strict.name = "vsss-3v3 with all fouls";
  strict.fouls.push = true;
  strict.fouls.holding = true;
  strict.periods.swap_sides = true;
  strict.restart.delay = 0.5;
  strict.restart.goal_delay = 1.0;
  all.push_back(all.front());
  Rules& kicks = all.back();
  kicks.name = "vsss-3v3 with shoot-outs";
  kicks.periods.tie_break = TieBreak::kShootOut;
  kicks.restart.delay = 0.25;
  return all;
}

void judgeMatch(int index, double half_seconds, std::uint64_t first_seed, Verdict& verdict) {
  static const std::vector<Pairing> all = pairings();
  static const std::vector<Rules> profiles = judgedRules();
  const auto i = static_cast<std::size_t>(index);
  const Pairing& pairing = all[i % all.size()];
  const Rules& rules = profiles[i / all.size() % profiles.size()];
  const std::uint64_t seed = first_seed + i;
  Match match = matchOf(pairing.blue, pairing.yellow, rules, half_seconds, seed);
  SecondReferee second;
  match.watch(second);
  while (match.step()) {
  }
  ++verdict.matches;
  for (const auto& [clause, tally] : second.tallies()) {
    Tally& sum = verdict.tallies[clause];
    sum.both += tally.both;
    sum.match_alone += tally.match_alone;
    sum.second_alone += tally.second_alone;
  }
  for (const std::string& line : second.disagreements()) {
    verdict.disagreements.push_back(
        fmt::format("{} v {}, {}, seed {}: {}", pairing.blue, pairing.yellow, rules.name, seed, line));
  }
}

}  // namespace fulbito::second
