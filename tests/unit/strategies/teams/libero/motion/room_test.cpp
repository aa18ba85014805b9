#include "strategies/teams/libero/motion/room.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "referee/rules/clauses.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Counts charges of the keeper, and the ticks in which blue presses on robot 0 of yellow.
struct Charges final : MatchObserver {
  int calls = 0, pressed = 0;

  void onTick(const MatchTick& tick) override {
    for (const GameEvent& event : tick.events) {
      if (event.clause == clause::kKeeperCharged && event.team == TeamId::kBlue) ++calls;
    }
    for (const ContactEvent& contact : tick.contacts) {
      if (contact.a.kind != BodyKind::kRobot || contact.b.kind != BodyKind::kRobot) continue;
      const RobotId a = tick.ids[contact.a.index], b = tick.ids[contact.b.index];
      const RobotId keeper{TeamId::kYellow, 0};
      if (a.team != b.team && (a == keeper || b == keeper)) ++pressed;
    }
  }
};

/// Charges when a keeper stands still between a striker at speed and a ball beside the keeper.
Charges chargesOf(double keeper, Vec2 ball) {
  Placement scene;
  scene.ball = ball;
  scene.robots[0][0] = Pose2{{-0.708, 0.0}, math::kPi / 2};
  scene.robots[0][1] = Pose2{{0.35, keeper}, 0.0};
  scene.robots[1][0] = Pose2{{0.66, keeper}, math::kPi / 2};
  Match match = test::matchFrom(test::matchOf("libero", "idle", "vsss-3v3", 10.0), scene);
  Charges charges;
  match.watch(charges);
  while (match.seconds() < 3.0 && match.referee().score[0] == 0 && match.step()) {
  }
  return charges;
}

Observation beforeKeeper(Vec2 robot, Vec2 velocity, Vec2 ball) {
  Observation seen;
  seen.own[0] = test::standingAt({{-0.71, 0.0}, math::kPi / 2});
  seen.own[1] = test::standingAt({robot, 0.0});
  seen.own[1].state.velocity = velocity;
  seen.opponents[0] = test::standingAt({{0.68, 0.0}, math::kPi / 2});
  seen.ball.position = ball;
  return seen;
}

}  // namespace

TEST_CASE("libero goes round a keeper that stands between it and the ball", "[unit]") {
  int pressed = 0;
  for (const double keeper : {-0.15, 0.0, 0.15}) {
    for (const Vec2 ball : {Vec2{0.72, 0.30}, Vec2{0.72, -0.30}, Vec2{0.70, 0.50}, Vec2{0.70, -0.50}}) {
      const Charges charges = chargesOf(keeper, ball);
      CAPTURE(keeper, ball.x, ball.y);
      CHECK(charges.calls == 0);
      pressed += charges.pressed;
    }
  }
  CHECK(pressed < 12 * 12);  // on average shorter than a charge that the referee calls
}

TEST_CASE("libero's second attacker leaves their goal's mouth without pushing the keeper before it",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    Placement scene;
    scene.ball = {-0.5, 0.3};
    scene.robots[0][0] = Pose2{{-0.708, 0.0}, math::kPi / 2};
    scene.robots[0][1] = Pose2{{-0.35, 0.3}, 0.0};
    scene.robots[0][2] = Pose2{{0.77, -0.02}, 3.0};
    scene.robots[1][0] = Pose2{{0.66, 0.0}, math::kPi / 2};
    Match match =
        test::matchFrom(test::matchOf("libero", "idle", "vsss-3v3", 10.0), test::mirrored(scene, side));
    Charges charges;
    match.watch(charges);
    while (match.seconds() < 3.0 && match.referee().score[0] == 0 && match.step()) {
    }
    CAPTURE(side);
    CHECK(charges.calls == 0);
    CHECK(charges.pressed < 12);
  }
}

TEST_CASE("in play libero hardly ever charges a keeper", "[unit]") {
  // Three matches of two minutes. Without room for a keeper, libero would have 18 calls against classic.
  for (const char* opponent : {"classic", "chaser"}) {
    int calls = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      MatchConfig config = test::matchOf("libero", opponent, "vsss-3v3", 60.0);
      config.seed = seed;
      auto match = Match::create(config);
      REQUIRE(match);
      Charges charges;
      match->watch(charges);
      while (match->step()) {
      }
      calls += charges.calls;
    }
    CAPTURE(opponent);
    CHECK(calls <= 4);
  }
}

TEST_CASE("libero brakes or turns off before a keeper that it drives at, unless it has the ball", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  libero::BallForecast ball;
  const Twist ahead{pitch.speed, 0.0};
  const auto off = [&](const Observation& seen, double dispute_left) {
    libero::Picture picture{seen, pitch, ball};
    picture.dispute_left[1] = dispute_left;
    libero::SlideMemory slide;
    return libero::clearOfKeeper(picture, 1, ahead, slide);
  };
  const double braking = pitch.speed * pitch.speed / (2.0 * pitch.acceleration);
  const double touch = 0.68 - 2.0 * pitch.robot_half;
  const auto at = [&](double gap) {
    return beforeKeeper({touch - gap, 0.0}, {pitch.speed, 0.0}, {0.7, 0.4});
  };
  CHECK_FALSE(off(at(2.0 * braking + 0.05), 0.0));
  CHECK(off(at(0.5 * braking), 0.0));
  CHECK_FALSE(off(at(0.5 * braking), 0.1));
  // A keeper outside its area is a normal opponent.
  Observation out = at(0.5 * braking);
  out.own[1].state.pose.position.x -= 0.5;
  out.opponents[0].state.pose.position.x -= 0.5;
  CHECK_FALSE(off(out, 0.0));
  // A robot that touches the keeper leaves it.
  const auto leaves = off(beforeKeeper({touch, 0.0}, {}, {0.7, 0.4}), 0.0);
  REQUIRE(leaves);
  CHECK(leaves->kind != RobotCommand::Kind::kGoTo);
  CHECK((leaves->kind == RobotCommand::Kind::kWheels ? leaves->wheels.left : leaves->twist.linear) < 0.0);
}

TEST_CASE("libero goes on past a keeper if it is at the ball before the contact becomes a foul", "[unit]") {
  MatchInfo info = test::infoOf(3);
  const auto isKept = [&](double beyond) {
    const libero::Pitch pitch(info);
    libero::BallForecast ball;
    const double x = 0.68 - 2.0 * pitch.robot_half - pitch.tuning.clearance;
    // The ball is beside the keeper, `beyond` the robot's face.
    const Observation seen =
        beforeKeeper({x, 0.07}, {0.3, 0.0}, {x + pitch.front + beyond, 0.07 + pitch.robot_half / 2});
    ball.take(seen.ball, {});
    const libero::Picture picture{seen, pitch, ball};
    libero::SlideMemory slide;
    return libero::clearOfKeeper(picture, 1, {pitch.speed, 0.0}, slide).has_value();
  };
  CHECK_FALSE(isKept(0.02));
  CHECK(isKept(0.08));
  info.rules.keeper.charge_seconds = 0.04;
  CHECK(isKept(0.02));
}

TEST_CASE("libero keeps its way along a keeper for a while, whatever it wishes then", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  libero::BallForecast ball;
  Observation seen =
      beforeKeeper({0.68 - 2.0 * pitch.robot_half - 2.5 * pitch.tuning.clearance, 0.01}, {}, {0.7, 0.4});
  ball.take(seen.ball, {});
  seen.dt = pitch.tick;
  const libero::Picture picture{seen, pitch, ball};
  libero::SlideMemory slide;
  const auto turns = [&](Twist wanted) {
    const auto command = libero::clearOfKeeper(picture, 1, wanted, slide);
    return command && command->kind == RobotCommand::Kind::kTwist ? command->twist.angular : 0.0;
  };
  const double first = turns({pitch.speed, 0.0});
  REQUIRE(first != 0.0);
  const Twist away{-pitch.speed, 0.0}, across{pitch.speed, -std::copysign(5.0, first)};
  for (double passed = 2 * pitch.tick; passed < pitch.turn_time; passed += pitch.tick)
    CHECK(turns(passed < pitch.turn_time / 2 ? away : across) * first > 0.0);
  for (int i = 0; i < 2; ++i) turns(away);
  CHECK(turns(away) == 0.0);
}

TEST_CASE("of two mates that converge the one of lower role gives way, and both after long contact",
          "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  libero::BallForecast ball;
  Observation seen;
  seen.own[0] = test::standingAt({{-0.71, 0.0}, math::kPi / 2});
  seen.own[1] = test::standingAt({{-0.2, 0.0}, 0.0});
  seen.own[2] = test::standingAt({{-0.2 + 2.5 * pitch.robot_half, 0.0}, 0.0});
  libero::Picture picture{seen, pitch, ball};
  picture.keeper = 0, picture.striker = 1;
  const auto off = [&](int robot, double speed) {
    libero::YieldMemory memory;
    return libero::clearOfMates(picture, robot, {speed * pitch.speed, 0.0}, memory);
  };
  // Robot 1 stands behind robot 2 and goes first.
  CHECK_FALSE(off(1, 1.0));
  seen.own[2].state.velocity = {-0.5 * pitch.speed, 0.0};
  CHECK(off(2, -1.0));
  seen.own[2].state.velocity = {};
  CHECK_FALSE(off(2, 1.0));
  // In contact, the lower leaves whatever it wants.
  seen.own[2].state.pose.position.x = -0.2 + 2.0 * pitch.robot_half + 0.001;
  CHECK_FALSE(off(1, 1.0));
  CHECK(off(2, 0.0));
  // If the lower cannot leave, the higher does, also at the ball.
  seen.dt = pitch.tick;
  const double touching = seen.own[2].state.pose.position.x;
  const auto leavesAfter = [&](double noise) {
    libero::YieldMemory memory;
    for (int tick = 0; tick < 200; ++tick) {
      // In every fourth tick the robots seem apart.
      seen.own[2].state.pose.position.x = touching + (tick % 4 == 3 ? noise : 0.0);
      if (libero::clearOfMates(picture, 1, {pitch.speed, 0.0}, memory)) return tick * seen.dt;
    }
    return 200 * seen.dt;
  };
  CHECK(leavesAfter(0.0) == Approx(2 * pitch.turn_time).margin(2 * seen.dt));
  CHECK(leavesAfter(0.01) == Approx(4 * pitch.turn_time).margin(4 * seen.dt));
  picture.dispute_left[1] = 1.0;
  CHECK(leavesAfter(0.0) == Approx(2 * pitch.turn_time).margin(2 * seen.dt));
}

TEST_CASE("a robot leaves the mate that it touches, whatever mate is before it", "[unit]") {
  const libero::Pitch pitch(test::infoOf(5));
  libero::BallForecast ball;
  Observation seen;
  seen.team_size = 5;
  const Vec2 ahead{0.0, 2.2 * pitch.robot_half}, beside{-2.0 * pitch.robot_half - 0.001, 0.0};
  seen.own[3] = test::standingAt({{0.0, 0.0}, math::kPi / 2});
  // One of them is striker, the other a support of smaller rank: robot 3 gives way to both.
  for (const int touched : {1, 2}) {
    seen.own[static_cast<std::size_t>(touched)] = test::standingAt({beside, 0.0});
    seen.own[static_cast<std::size_t>(3 - touched)] = test::standingAt({ahead, 0.0});
    libero::Picture picture{seen, pitch, ball};
    picture.keeper = 0, picture.striker = 1;
    picture.rank[3] = 1;
    libero::YieldMemory memory;
    REQUIRE(libero::clearOfMates(picture, 3, {pitch.speed, 0.0}, memory));
    CHECK(memory.left == pitch.turn_time);
  }
}

TEST_CASE("a robot that touches a mate keeps its way off for a moment", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  libero::BallForecast ball;
  Observation seen;
  seen.dt = pitch.tick;
  const double apart = 2.0 * pitch.robot_half + 0.001;
  seen.own[1] = test::standingAt({{0.0, 0.0}, 0.0});
  seen.own[2] = test::standingAt({{apart, 0.0}, 0.0});
  libero::Picture picture{seen, pitch, ball};
  picture.keeper = 0, picture.striker = 1;
  libero::YieldMemory memory;
  const auto first = libero::clearOfMates(picture, 2, {}, memory);
  REQUIRE(first);
  // From the other side another way would be shorter.
  seen.own[2].state.pose.position.x = -apart;
  const auto forward = [](const RobotCommand& command) {
    return command.kind == RobotCommand::Kind::kWheels ? command.wheels.left : command.twist.linear;
  };
  const auto ticks = static_cast<int>(pitch.turn_time / pitch.tick);
  for (int i = 1; i < ticks; ++i) {
    const auto next = libero::clearOfMates(picture, 2, {}, memory);
    REQUIRE(next);
    CHECK(forward(*next) == forward(*first));
  }
  std::optional<RobotCommand> other;
  for (int i = 0; i < 2; ++i) other = libero::clearOfMates(picture, 2, {}, memory);
  REQUIRE(other);
  CHECK(forward(*other) * forward(*first) < 0.0);
}

TEST_CASE("a mate at the ball goes before the striker that is not", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  libero::BallForecast ball;
  Observation seen;
  seen.own[1] = test::standingAt({{0.0, 0.0}, 0.0});
  seen.own[2] = test::standingAt({{2.0 * pitch.robot_half + 0.001, 0.0}, 0.0});
  std::array<double, kMaxTeamSize> disputes{};
  const auto yields = [&](int robot) {
    libero::Picture picture{seen, pitch, ball, 0.0, disputes};
    picture.keeper = 0, picture.striker = 1;
    libero::YieldMemory memory;
    return libero::clearOfMates(picture, robot, {}, memory).has_value();
  };
  CHECK_FALSE(yields(1));
  CHECK(yields(2));
  disputes[2] = 0.1;
  CHECK(yields(1));
  CHECK_FALSE(yields(2));
}

TEST_CASE("who touches the ball disputes it", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  RobotState robot;
  robot.pose = {{0.3, 0.1}, 0.7};
  const double touch = pitch.robot_half + pitch.ball_radius;
  CHECK(libero::atBall(pitch, robot, robot.pose.position + (touch + 0.004) * math::unit(0.7)));
  CHECK_FALSE(libero::atBall(pitch, robot, robot.pose.position + (touch + 0.006) * math::unit(0.7)));
}

TEST_CASE("libero's striker drives off beside their keeper instead of turning to and fro", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    Placement scene;
    scene.ball = {0.60, -0.50};
    scene.robots[0] = {Pose2{{-0.7, 0.0}, 1.57}, Pose2{{0.645, -0.11}, -2.02}};
    scene.robots[1] = {Pose2{{0.74, -0.15}, -1.87}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 1.0, "idle", "firasim");
    const Vec2 place = match.world().robots[1].pose.position;
    CAPTURE(side, place.x, place.y);
    CHECK(side * place.y < -0.2);
  }
}

}  // namespace fulbito
