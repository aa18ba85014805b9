#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// How far [m] the ball is beyond the half-way line, seen by the team `kicks`, 2 s after its goal kick.
double ballAfterGoalKick(const char* kicks, const char* other, const char* model, TeamId seat) {
  const Match match = test::playedFromRestart(RestartKind::kGoalKick, kicks, other, seat, model, 2.5);
  return (seat == TeamId::kBlue ? 1.0 : -1.0) * match.world().balls.front().position.x;
}

}  // namespace

TEST_CASE("libero's goal kick goes past opponents into their half", "[unit]") {
  for (const char* model : {"vsss", "firasim"}) {
    for (const char* other : {"chaser", "classic", "univector"}) {
      for (const TeamId seat : {TeamId::kBlue, TeamId::kYellow}) {
        CAPTURE(model, other, static_cast<int>(seat));
        CHECK(ballAfterGoalKick("libero", other, model, seat) > 0.0);
      }
    }
  }
  CHECK(ballAfterGoalKick("libero:without=goal-kick", "chaser", "firasim", TeamId::kBlue) < 0.0);
}

}  // namespace fulbito
