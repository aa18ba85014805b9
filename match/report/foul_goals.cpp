#include "match/report/foul_goals.hpp"

#include "fulbito/referee.hpp"
#include "referee/rules/clauses.hpp"

namespace fulbito {

std::optional<std::string_view> FoulGoalFinder::take(const GameEvent& event, Tick played, double dt) {
  if (!event.team) return std::nullopt;
  std::optional<Foul>& last = last_[indexOf(*event.team)];
  if (clause::isFoul(event.clause)) last = Foul{played, event.clause};
  if (event.clause != clause::kGoal || !last) return std::nullopt;
  constexpr double kRounding = 1e-9;  // [s]
  if (static_cast<double>(played - last->played) * dt > kFoulPaysWithin + kRounding) return std::nullopt;
  return last->clause;
}

}  // namespace fulbito
