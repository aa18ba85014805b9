#include "strategies/teams/libero/situation/free_balls.hpp"

namespace fulbito::libero {

void FreeBalls::watch(const Observation& seen, bool play_began, double soon) {
  if (open_ && seen.own_score > score_) ++goals_, open_ = false;
  if (play_began) {
    open_ = seen.restart == RestartKind::kFreeBall && seen.restart_is_ours;
    if (open_) ++taken_, score_ = seen.own_score;
  }
  if (seen.playing && seen.since_restart > soon) open_ = false;
}

}  // namespace fulbito::libero
