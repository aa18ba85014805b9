#include "strategies/teams/libero/exercise.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The state of a robot that starts in the middle, after `ticks` of a task.
RobotState exercised(const MatchInfo& info, const Exercise& task, Vec2 ball, int ticks) {
  const libero::Pitch pitch(info);
  libero::ExerciseMemory memory;
  RobotState robot;
  for (int tick = 0; tick < ticks; ++tick) {
    robot = test::driven(info, robot, libero::exerciseTwist(pitch, robot, ball, task, memory));
  }
  return robot;
}

}  // namespace

TEST_CASE("libero's first robot reaches poses and headings that a drill asks for", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  Rng rng(1, test::kTestStream);
  for (int run = 0; run < 100; ++run) {
    Exercise task;
    task.heading = rng.uniform(-math::kPi, math::kPi);
    task.target = {rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
    const RobotState there = exercised(info, task, {}, 240);
    CAPTURE(run);
    CHECK(distance(there.pose.position, task.target) < 0.015);
    task.kind = Exercise::Kind::kTurn;
    const RobotState turned = exercised(info, task, {}, 60);
    CHECK(std::abs(math::wrapAngle(turned.pose.heading - task.heading)) < 0.03);
    CHECK(norm(turned.pose.position) < 0.005);
  }
}

TEST_CASE("libero's first robot comes through the ball at the heading and speed that a drill asks for",
          "[unit]") {
  // A robot of FIRASim needs a run-up that is four times as long.
  const MatchInfo info = test::infoOf(3, GENERATE("vsss", "firasim"));
  const libero::Pitch pitch(info);
  Rng rng(2, test::kTestStream);
  for (int run = 0; run < 50; ++run) {
    Exercise task;
    task.kind = Exercise::Kind::kReachBall;
    task.heading = rng.uniform(-math::kPi, math::kPi);
    task.speed = 0.8;
    const Vec2 ball = math::unit(rng.uniform(-math::kPi, math::kPi)) * 0.3, along = math::unit(task.heading);
    libero::ExerciseMemory memory;
    RobotState robot;
    int tick = 0;
    while (++tick < 600 && distance(robot.pose.position, ball) > pitch.robot_half + pitch.ball_radius) {
      robot = test::driven(info, robot, libero::exerciseTwist(pitch, robot, ball, task, memory));
    }
    CAPTURE(run);
    CHECK(tick < 600);
    CHECK(memory.runs_up);
    CHECK(std::abs(cross(along, ball - robot.pose.position)) < 0.01);
    CHECK(dot(robot.velocity, along) > task.speed);
  }
}

}  // namespace fulbito
