#include <string>

#include "strategies/teams/libero/playbook/playbook.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

namespace {

/// The yaw rate [rad/s] of the spin of a robot at `robot` beside an opponent; 0: it does not spin.
double spins(const char* model, Vec2 place, Vec2 robot, Vec2 opponent) {
  const libero::Pitch pitch(test::infoOf(3, model));
  Observation seen;
  seen.team_size = 3;
  seen.own[1] = test::standingAt({place + robot, 0.0});
  seen.opponents[0] = test::standingAt({place + opponent, math::kPi});
  seen.ball.position = place;
  libero::BallForecast ball;
  ball.take(seen.ball, {});
  libero::Memory memory;
  const auto move = libero::striker::spin({seen, pitch, ball}, 1, memory);
  return move ? move->twist.angular : 0.0;
}

/// Whether a spin that has begun goes on with the ball `away` [m] from the robot. Where it does not, the next
/// spin has to wait.
bool spinsOn(double away) {
  const libero::Pitch pitch(test::infoOf(3, "firasim"));
  Observation seen;
  seen.team_size = 3;
  seen.own[1] = test::standingAt({{0.3, 0.2}, 0.0});
  seen.ball.position = {0.3, 0.2 - away};
  libero::BallForecast ball;
  ball.take(seen.ball, {});
  libero::Memory memory;
  memory.spin.left = pitch.tuning.spin_time / 2;
  const auto move = libero::striker::spinOn({seen, pitch, ball}, 1, memory);
  CHECK((memory.spin.left > 0.0) == move.has_value());
  CHECK((memory.spin.locked > 0.0) == !move.has_value());
  return move.has_value();
}

}  // namespace

TEST_CASE("a spin ends early once the ball has left", "[unit]") {
  CHECK(spinsOn(0.06));
  CHECK(spinsOn(0.10));
  CHECK_FALSE(spinsOn(0.13));
}

TEST_CASE("robots that cannot push each other away spin: past their goal, or away from ours", "[unit]") {
  const Vec2 behind{-0.06, 0.0}, ahead{0.06, 0.0};
  for (const double side : {1.0, -1.0}) {
    CHECK(side * spins("firasim", {0.3, side * 0.2}, behind, ahead) < 0.0);
    CHECK(side * spins("firasim", {-0.3, side * 0.2}, behind, ahead) > 0.0);
    CHECK(spins("vsss", {0.3, side * 0.2}, behind, ahead) == 0.0);
    // Beside the ball, the spin throws it toward their goal.
    CHECK(side * spins("firasim", {0.55, 0.0}, {0.0, -side * 0.06}, {0.3, 0.0}) < 0.0);
    CHECK(spins("firasim", {0.3, 0.0}, {0.0, -side * 0.06}, {0.3, 0.0}) == 0.0);
    // At a wall the ball has no room to leave.
    CHECK(spins("firasim", {0.6, side * 0.63}, {0.06, 0.0}, {0.12, 0.0}) == 0.0);
    CHECK(spins("vsss", {0.6, side * 0.63}, {0.06, 0.0}, {0.12, 0.0}) == 0.0);
  }
}

TEST_CASE("libero's striker answers a stand-off in its own half before it blocks", "[unit]") {
  const auto reason = [](const char* model) {
    const libero::Pitch pitch(test::infoOf(3, model));
    Observation seen;
    seen.team_size = 3;
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 10.0;
    seen.own[1] = test::standingAt({{-0.36, 0.2}, 0.0});
    seen.opponents[0] = test::standingAt({{-0.24, 0.2}, math::kPi});
    seen.ball.position = {-0.3, 0.2};
    libero::BallForecast ball;
    ball.take(seen.ball, {});
    libero::Memory memory;
    return std::string(
        libero::PlayBook().decide(libero::Role::kStriker, {seen, pitch, ball}, 1, memory).reason);
  };
  CHECK(reason("firasim") == "nobody gives way");
  CHECK(reason("vsss") == "an opponent is about to dribble at our goal");
}

}  // namespace fulbito
