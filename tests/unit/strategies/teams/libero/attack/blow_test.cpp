#include "strategies/teams/libero/attack/blow.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Time [s] until a single robot touches a rolling ball, which shows in a jump of the ball's velocity.
double secondsToTouch(const Placement& scene) {
  Match match = test::matchFrom(test::matchOf("libero", "idle", "vsss-3v3", 4.0), scene);
  Vec2 last = scene.ball_velocity;
  while (match.step()) {
    const Vec2 now = match.world().balls[0].velocity;
    if (norm(now - last) > 0.12) break;
    last = now;
  }
  return match.seconds();
}

}  // namespace

TEST_CASE("libero meets a ball that rolls across, rather than to go round it while it leaves", "[unit]") {
  struct Crossing {
    Pose2 robot;
    Vec2 ball, velocity;
    double least;  // [s] by the time estimate of docs/skills.md
  };
  // A robot that aims only at the best strike takes 0.45 to 1.7 s more than the least time.
  const Crossing crossings[] = {{{{-0.191, -0.126}, 0.51}, {-0.070, 0.484}, {0.10, -0.36}, 0.533},
                                {{{-0.224, -0.154}, -0.45}, {0.006, 0.530}, {0.06, -0.39}, 0.633},
                                {{{-0.153, 0.018}, -0.52}, {-0.065, -0.493}, {0.03, 0.44}, 0.433},
                                {{{-0.384, -0.111}, -0.19}, {0.376, -0.455}, {-0.12, 0.98}, 0.783},
                                {{{-0.349, -0.188}, -0.23}, {0.310, -0.533}, {-0.08, 0.98}, 0.700},
                                {{{-0.189, -0.049}, 0.09}, {-0.113, -0.423}, {0.17, 0.79}, 0.317}};
  for (const Crossing& c : crossings) {
    Placement scene;
    scene.ball = c.ball;
    scene.ball_velocity = c.velocity;
    scene.robots[0][1] = c.robot;
    for (const double side : {1.0, -1.0}) {
      CAPTURE(side);
      CHECK(secondsToTouch(test::mirrored(scene, side)) <= c.least + 0.2);
    }
  }
}

TEST_CASE("libero drives round a ball that runs ahead only where it speeds up fast", "[unit]") {
  // Ball and robot move aslant, and the goal is straight ahead.
  const libero::Aim aim{{}, {1.0, 0.0}, false};
  const auto turn = [&](const char* model, double side) {
    const libero::Pitch pitch(test::infoOf(3, model));
    const Vec2 robot = math::unit(side * 0.6) * -pitch.front;
    const Vec2 moving = math::unit(side * 0.6) * 0.5;
    return side * math::angleOf(libero::blowInTime(pitch, robot, aim, moving));
  };
  for (const double side : {1.0, -1.0}) {
    // It cancels the speed across, and adds to the speed along.
    const double along = libero::Tuning().strike_speed - 0.5 * math::cos(0.6);
    CHECK(turn("vsss", side) == Approx(-math::atan2(0.5 * math::sin(0.6), along)));
    CHECK(turn("firasim", side) == Approx(0.6 - libero::Tuning().turn_in));
  }
}

}  // namespace fulbito
