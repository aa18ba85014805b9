#include "strategies/teams/libero/situation/free_balls.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kSoon = 4.0;  // [s]

/// Plays a restart: `after` [s] after the signal, `goals` of ours fall.
struct Play {
  libero::FreeBalls free_balls;
  Observation seen;

  void restart(RestartKind kind, bool ours, int goals, double after) {
    seen.playing = true;
    seen.restart = kind;
    seen.restart_is_ours = ours;
    seen.since_restart = 0.0;
    free_balls.watch(seen, true, kSoon);
    seen.since_restart = after;
    free_balls.watch(seen, false, kSoon);
    seen.playing = false;
    seen.own_score += goals;
    free_balls.watch(seen, false, kSoon);
  }
};

}  // namespace

TEST_CASE("free balls pay until two more have brought nothing than a goal", "[unit]") {
  Play play;
  CHECK(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);
  CHECK(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);  // none of two
  CHECK_FALSE(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 1, 2.0);  // one of three
  CHECK(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);  // one of four
  CHECK_FALSE(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 1, 2.0);
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);  // two of six
  CHECK_FALSE(play.free_balls.pay());
  play.free_balls.forget();
  CHECK(play.free_balls.pay());
}

TEST_CASE("a free ball that has just begun is not yet one without a goal", "[unit]") {
  Play play;
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);
  CHECK(play.free_balls.pay());
  play.restart(RestartKind::kFreeBall, true, 0, 2.0);  // it might still bring one
  CHECK(play.free_balls.pay());
  play.seen.playing = true;
  play.seen.since_restart = kSoon + 0.1;
  play.free_balls.watch(play.seen, false, kSoon);
  CHECK_FALSE(play.free_balls.pay());
}

TEST_CASE("late goals and those of other restarts say nothing about free balls in their half", "[unit]") {
  Play play;
  play.restart(RestartKind::kFreeBall, true, 1, 20.0);
  play.restart(RestartKind::kFreeBall, false, 1, 2.0);
  play.restart(RestartKind::kKickOff, true, 1, 2.0);
  play.restart(RestartKind::kFreeBall, true, 0, 20.0);
  CHECK_FALSE(play.free_balls.pay());  // none of two
}

TEST_CASE("free balls of the other team say nothing", "[unit]") {
  Play play;
  play.restart(RestartKind::kFreeBall, false, 0, 20.0);
  play.restart(RestartKind::kFreeBall, false, 0, 20.0);
  CHECK(play.free_balls.pay());
}

}  // namespace fulbito
