#include "strategies/skills/kicking.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("a robot takes its kick-off until the ball has left", "[unit]") {
  Observation seen;
  seen.team_size = 1;
  seen.restart = RestartKind::kKickOff;
  seen.restart_is_ours = true;
  seen.own[0].present = true;
  seen.own[0].state.pose = {{-0.09, 0.0}, 0.0};
  CHECK(isKicking(seen, 0));
  seen.since_restart = 0.4;
  CHECK(isKicking(seen, 0));
  seen.ball.position = {0.2, 0.0};
  CHECK_FALSE(isKicking(seen, 0));  // the ball has left
  seen.since_restart = 0.1;
  CHECK(isKicking(seen, 0));
  seen.own[0].state.pose.heading = 0.2;
  CHECK_FALSE(isKicking(seen, 0));  // it was not placed for the kick
  CHECK(isKicking(seen, 0, {.straight = 0.3}));
  seen.own[0].state.pose.heading = 0.0;
  seen.since_restart = 0.7;
  CHECK_FALSE(isKicking(seen, 0));
  seen.since_restart = 0.1;
  seen.restart_is_ours = false;
  CHECK_FALSE(isKicking(seen, 0));
}

}  // namespace fulbito
