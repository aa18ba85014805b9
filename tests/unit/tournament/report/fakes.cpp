// Stand-ins until formats and ratings are merged.
#include <algorithm>
#include <cmath>

#include "tournament/report/table.hpp"
namespace fulbito {
std::string_view nameOf(StartKind kind) {
  constexpr std::string_view k[] = {"kick-off", "free-ball", "penalty", "goal-kick", "play"};
  return k[static_cast<std::size_t>(kind)];
}
BookEntry bookEntry(const BookConfig& book, std::size_t index) {
  const StartKind kind = book.kinds[index % book.kinds.size()];
  return {kind, std::string(nameOf(kind)) + ":" + std::to_string(index / book.kinds.size())};
}
bool TournamentState::finished() const {
  for (std::size_t i = 0; i < counted; ++i)
    if (!results[i]) return false;
  return schedule.complete || (sprt && sprt->verdict() != SprtVerdict::kInconclusive);
}
std::vector<Standing> standingsOf(const TournamentPlan& plan, const Schedule& schedule,
                                  const FixtureResults& results, std::size_t counted) {
  std::vector<Standing> list(plan.entrants.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].entrant = i;
    list[i].group = plan.groups > 1 ? static_cast<int>(i) % plan.groups : 0;
  }
  for (std::size_t i = 0; i < counted; ++i) {
    if (!results[i]) continue;
    const Fixture& f = schedule.fixtures[i];
    for (std::size_t leg = 0; leg < 2; ++leg)
      for (std::size_t seat = 0; seat < 2; ++seat) {
        Standing& s = list[leg == seat ? f.a : f.b];
        const MatchResult& r = results[i]->legs[leg];
        ++s.matches;
        s.goals_for += r.score[seat];
        s.goals_against += r.score[1 - seat];
        if (!r.winner) {
          ++s.drawn;
          s.points += 1;
        } else if (*r.winner == kTeams[seat]) {
          ++s.won;
          s.points += 3;
        } else
          ++s.lost;
      }
  }
  std::stable_sort(list.begin(), list.end(), [](auto& x, auto& y) {
    return std::tuple(x.group, -x.points) < std::tuple(y.group, -y.points);
  });
  for (std::size_t i = 0; i < list.size(); ++i) list[i].rank = static_cast<int>(i + 1);
  return list;
}
std::vector<KnockOutTie> bracketOf(const TournamentPlan& plan, const Schedule&, const FixtureResults&) {
  if (plan.format != TournamentFormat::kKnockOut) return {};
  return {{0, 0, std::nullopt, 0, "bye", 0, 0, 0, 0},
          {0, 1, 2, 1, "points", 1.5, 0.5, 4, 2},
          {1, 0, 1, std::nullopt, "", 0, 0, 0, 0}};
}
Ratings rate(std::size_t entrants, std::span<const MeetingCounts> meetings, std::uint64_t, std::size_t) {
  Ratings r;
  r.component.assign(entrants, 0);
  r.superiority.assign(entrants, std::vector<double>(entrants, 0.5));
  std::vector<double> points(entrants), games(entrants);
  for (const auto& m : meetings) {
    double n = static_cast<double>(m.pairs.pairs()), p = 0;
    for (std::size_t i = 0; i < 5; ++i) p += pairScore(i) * static_cast<double>(m.pairs.counts[i]);
    points[m.a] += p;
    points[m.b] += n - p;
    games[m.a] += n;
    games[m.b] += n;
  }
  for (std::size_t i = 0; i < entrants; ++i) {
    const double s = (points[i] + 0.5) / (games[i] + 1), e = -400 * std::log10(1 / s - 1),
                 w = 300 / std::sqrt(games[i] + 1);
    r.elo.push_back({e, e - w, e + w});
  }
  return r;
}
}  // namespace fulbito
