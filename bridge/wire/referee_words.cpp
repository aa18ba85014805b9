#include "bridge/wire/referee_words.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "fulbito/referee.hpp"

namespace fulbito::wire {
namespace {

struct Restart {
  RestartKind kind;
  Foul foul;
};
constexpr Restart kRestarts[] = {
    {RestartKind::kKickOff, Foul::kKickOff},   {RestartKind::kFreeBall, Foul::kFreeBall},
    {RestartKind::kFreeKick, Foul::kFreeKick}, {RestartKind::kPenalty, Foul::kPenaltyKick},
    {RestartKind::kGoalKick, Foul::kGoalKick},
};

}  // namespace

Foul foulOf(RestartKind kind) {
  const auto* restart =
      std::find_if(std::begin(kRestarts), std::end(kRestarts), [&](Restart w) { return w.kind == kind; });
  return restart == std::end(kRestarts) ? Foul::kStop : restart->foul;
}

RestartKind restartOf(Foul foul) {
  const auto* restart =
      std::find_if(std::begin(kRestarts), std::end(kRestarts), [&](Restart w) { return w.foul == foul; });
  return restart == std::end(kRestarts) ? RestartKind::kGiven : restart->kind;
}

Half halfOf(int period, int overtime_part) {
  constexpr std::array kHalves = {Half::kNone, Half::kFirst, Half::kSecond, Half::kOvertimeFirst,
                                  Half::kShootOut};
  if (period == kOvertimePeriod && overtime_part > 1) return Half::kOvertimeSecond;
  return kHalves[static_cast<std::size_t>(std::clamp(period, 0, kShootOutPeriod))];
}

int periodOf(Half half) {
  constexpr std::array kPeriods = {1, 1, 2, kOvertimePeriod, kOvertimePeriod, kShootOutPeriod};
  return kPeriods[static_cast<std::size_t>(half)];
}

int quadrantOf(Vec2 ball) {
  if (ball.y > 0.0) return ball.x > 0.0 ? 1 : 2;
  return ball.x > 0.0 ? 4 : 3;
}

bool sameCommand(const RefereeCommand& a, const RefereeCommand& b) {
  return a.foul == b.foul && a.team == b.team && a.quadrant == b.quadrant && a.half == b.half;
}

}  // namespace fulbito::wire
