#include "strategies/teams/libero/motion/bounds.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/quick_twist.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's areas step never lets a robot in that can still stop outside", "[unit]") {
  // For any control period, since the guard predicts the robot with the match's own ticks.
  const int rate = GENERATE(60, 30, 200);  // [Hz]
  MatchInfo info = test::infoOf(3);
  info.physics.control_rate = rate;
  const libero::Pitch pitch(info);
  const libero::BallForecast ball;
  const double dt = info.physics.controlPeriod();
  Rng rng{3, test::kTestStream, 0};
  int near = 0;
  for (int run = 0; run < 400; ++run) {
    const bool own = run % 2 == 0;
    const double sign = own ? 1.0 : -1.0;
    const double least = own ? pitch.tuning.area_margin : 2 * pitch.tuning.area_margin + pitch.robot_corner;
    const auto outside = [&](Vec2 p) { return distanceToArea(info.field, p, own); };
    Observation seen;
    seen.team_size = 3;
    RobotState& robot = seen.own[1].state;
    seen.own[1].present = true;
    // From rest at random places, with random commands that change at random times.
    do {
      robot.pose = {{-sign * rng.uniform(0.3, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(-3.14, 3.14)};
    } while (outside(robot.pose.position) < least + 0.01);
    Twist wanted;
    for (double time = 0.0; time < 4.0; time += dt) {
      if (rng.uniform(0.0, 1.0) < 3.6 * dt) wanted = {rng.uniform(-1.2, 1.2), rng.uniform(-12.0, 12.0)};
      const libero::Picture picture{seen, pitch, ball};
      const RobotCommand command = libero::keptOut(picture, 1, {own, !own}, wanted);
      const WheelSpeeds wheels = command.kind == RobotCommand::Kind::kWheels
                                     ? command.wheels
                                     : quickTwist(info.robot, robot, command.twist, dt).wheels;
      robot = rolledForward(info.robot, robot, saturate(info.robot, wheels), dt);
      const double room = outside(robot.pose.position);
      near += room < least + 0.02 ? 1 : 0;
      // A defender counts as inside with its centre on the line, an attacker with its corner.
      REQUIRE(room > (own ? 0.0 : pitch.robot_corner + pitch.tuning.area_margin / 2));
    }
  }
  CHECK(near > 1000);
}

TEST_CASE("libero's defender stops so far before its area that a blow does not knock it in", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    const MatchInfo info = test::infoOf(3, robot);
    const libero::Pitch pitch(info);
    const libero::BallForecast ball;
    Observation seen;
    seen.team_size = 3;
    seen.own[1] = test::standingAt({{-0.45, -0.2}, math::kPi});
    RobotState& self = seen.own[1].state;
    for (int tick = 0; tick < 120; ++tick) {
      const RobotCommand command = libero::keptOut({seen, pitch, ball}, 1, {true, false}, {pitch.speed, 0.0});
      const WheelSpeeds wheels = command.kind == RobotCommand::Kind::kWheels
                                     ? command.wheels
                                     : quickTwist(info.robot, self, command.twist, pitch.tick).wheels;
      self = rolledForward(info.robot, self, saturate(info.robot, wheels), pitch.tick);
      if (norm(self.velocity) < 0.01 && tick > 10) break;
    }
    const double blow = pitch.shoves ? pitch.speed / 2 : 0.0;  // [m/s] of both after it
    CHECK(distanceToArea(info.field, self.pose.position, true) > blow * blow / (2 * pitch.braking));
  }
}

TEST_CASE("libero's pressed defender comes no nearer to its area, but does not drive out", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const libero::BallForecast ball;
  const auto kept = [&](double room, Vec2 speed, Twist wanted) {
    Observation seen;
    seen.team_size = 3;
    const double x = -pitch.half_length + info.field.goal_area_depth + room;
    seen.own[1] = test::standingAt({{x, -0.2}, math::kPi / 2});
    seen.own[1].state.velocity = speed;
    seen.opponents[1] = test::standingAt({{x + 0.15, 0.0}, math::kPi});
    seen.opponents[1].state.velocity = {-0.6, 0.0};
    return libero::keptOut({seen, pitch, ball}, 1, {true, false}, wanted);
  };
  const double knocked = pitch.speed * pitch.speed / (8 * pitch.braking);  // [m] by a blow
  for (const double room : {0.03, 0.05, 0.09}) {
    const RobotCommand along = kept(knocked + room, {}, {1.0, 0.0});
    REQUIRE(along.kind == RobotCommand::Kind::kTwist);
    CHECK(along.twist.linear == Approx(1.0));
    CHECK(along.twist.angular == Approx(0.0).margin(1e-9));
  }
  // One that rolls in is turned away, pressed or not.
  const RobotCommand inward = kept(0.05, {-0.5, 0.0}, {1.0, 5.0});
  CHECK((inward.kind != RobotCommand::Kind::kTwist || inward.twist.angular < 5.0));
}

TEST_CASE("libero's second attacker leaves their goal's mouth by its front", "[unit]") {
  // From within the mouth the shortest way out of the area leads into the post, which would hold the robot.
  const FieldGeometry field = test::infoOf(3).field;
  for (const double side : {1.0, -1.0}) {
    for (const double heading : {-1.57, 0.4, 1.57}) {
      Placement scene;
      scene.ball = {-0.5, 0.3};
      scene.robots[0][0] = Pose2{{-0.708, 0.0}, 1.57};
      scene.robots[0][1] = Pose2{{-0.35, 0.3}, 0.0};
      scene.robots[0][2] = Pose2{{0.735, -0.12}, heading};
      const Match match = test::playedFrom(test::mirrored(scene, side), 1.5);
      const Vec2 place = match.world().robots[2].pose.position;
      CAPTURE(side, heading, place.x, place.y);
      CHECK(distanceToArea(field, place, false) > 0.0);
    }
  }
}

}  // namespace fulbito
