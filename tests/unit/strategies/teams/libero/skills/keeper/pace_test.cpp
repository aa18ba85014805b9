#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/skills/quick_twist.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// A keeper with a ball, and what the skill answers.
struct Scene {
  MatchInfo info;
  libero::Pitch pitch{info};
  Observation seen;
  libero::BallForecast forecast;
  libero::Memory memory;

  explicit Scene(const char* robot, Vec2 ball) : info(test::infoOf(3, robot)), pitch(info) {
    seen.team_size = 3;
    seen.dt = pitch.tick;
    seen.ball.position = ball;
    seen.own[0] = test::standingAt({{libero::keeperLine(pitch), 0.0}, math::kPi / 2});
    forecast.take(seen.ball, {});
  }
  std::optional<libero::Move> answer() { return libero::keeper::pace({seen, pitch, forecast}, 0, memory); }
};

}  // namespace

TEST_CASE("libero's keeper stays on the move at its place while the ball is far", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    Scene scene(robot, {0.3, 0.0});
    WorldConfig config;
    config.field = scene.info.field;
    config.robots.push_back({scene.info.robot, scene.seen.own[0].state.pose, {}, 0.0});
    auto world = World::create(config);
    REQUIRE(world);
    int slow = 0, ticks = 0;
    double most_left = 0.0, most_right = 0.0;
    for (; ticks < 600; ++ticks) {
      RobotState& self = scene.seen.own[0].state;
      self = world->state().robots.front();
      auto move = scene.answer();
      if (!move)
        move = libero::keeper::standInGoal({scene.seen, scene.pitch, scene.forecast}, 0, scene.memory);
      const WheelSpeeds wheels = quickTwist(scene.info.robot, self, move->twist, scene.pitch.tick).wheels;
      world->step({&wheels, 1});
      slow += norm(self.velocity) < 0.05 ? 1 : 0;
      most_left = std::max(most_left, self.pose.position.y);
      most_right = std::max(most_right, -self.pose.position.y);
    }
    CHECK(4 * slow < ticks);
    CHECK(most_left > scene.pitch.ball_radius / 2);
    CHECK(most_right > scene.pitch.ball_radius / 2);
    CHECK(std::max(most_left, most_right) < scene.pitch.ball_radius + scene.pitch.tuning.clearance);
  }
}

TEST_CASE("libero's keeper stands still for a near ball and leaves its place for a shot", "[unit]") {
  CHECK(Scene("vsss", {-0.2, 0.0}).answer());
  CHECK_FALSE(Scene("vsss", {-0.4, 0.0}).answer());
  // A robot that speeds up slowly has less time.
  CHECK(Scene("firasim", {0.3, 0.0}).answer());
  CHECK_FALSE(Scene("firasim", {-0.2, 0.0}).answer());

  Scene away("vsss", {0.3, 0.0});
  away.seen.own[0].state.pose.position.y = 0.1;
  CHECK_FALSE(away.answer());

  Scene shot("vsss", {0.1, 0.0});
  CHECK(shot.answer());
  shot.seen.ball.velocity = shot.seen.ball.spin = {-1.5, 0.0};
  BallPrediction way;
  way.predict(BallCourse(shot.info.field, shot.info.ball, shot.info.physics), shot.seen.ball);
  shot.forecast.take(shot.seen.ball, way);
  CHECK_FALSE(shot.answer());
}

}  // namespace fulbito
