#include "apps/simulator/simulated_field.hpp"

#include <cmath>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::simulator {
namespace {

using wire::Oddity;
using wire::Packet;

constexpr SimulatedField::Wheels kStill{};

MatchConfig config() {
  auto config = MatchConfig::standard("idle", "idle");
  REQUIRE(config);
  config->robot = *loadRobot("firasim");
  return *config;
}

SimulatedField fieldOf(const MatchConfig& config) {
  auto field = SimulatedField::create(config, startOf(config));
  REQUIRE(field);
  return std::move(*field);
}

Packet putting(std::uint32_t number, TeamId team, const Pose2& pose, bool on = true) {
  Packet packet;
  packet.robots.push_back({number, team, pose, on});
  return packet;
}

Packet rolling(Vec2 position, Vec2 velocity) {
  Packet packet;
  packet.ball = wire::BallReplacement{position, velocity};
  return packet;
}

/// All wheels of blue at these speeds.
SimulatedField::Wheels blueAt(WheelSpeeds speeds) {
  SimulatedField::Wheels wheels{};
  wheels[0].fill(speeds);
  return wheels;
}

void run(SimulatedField& field, const SimulatedField::Wheels& wheels, int ticks) {
  for (int i = 0; i < ticks; ++i) REQUIRE(field.step(wheels));
}

const RobotState& blue(const wire::Vision& vision, std::size_t index) {
  REQUIRE(vision.robots[0].size() > index);
  return vision.robots[0][index].state;
}

wire::OddityLog quiet() {
  return {[] { return std::int64_t{0}; }, {}};
}

}  // namespace

TEST_CASE("robots stand as at the first kick-off, or as the start says", "[unit]") {
  MatchConfig match = config();
  const wire::Vision vision = fieldOf(match).vision();
  for (const TeamId team : kTeams) {
    REQUIRE(vision.robots[indexOf(team)].size() == 3);
    const double goal = team == TeamId::kBlue ? -0.675 : 0.675;
    CHECK(vision.robots[indexOf(team)][0].state.pose.position.x == Approx(goal).margin(0.01));
  }
  CHECK(vision.ball.position == Vec2{});
  CHECK(vision.goals == PerTeam<std::uint32_t>{});
  match.start = Placement{{0.2, 0.1}, {}, {}};
  match.start->robots[1][2] = Pose2{{0.5, 0.0}, 0.0};
  SimulatedField given = fieldOf(match);
  CHECK(given.on(TeamId::kBlue) == 0);
  CHECK(given.on(TeamId::kYellow) == 4);
  // A robot that was not there comes with its first replacement.
  wire::OddityLog log = quiet();
  CHECK(given.replace(putting(1, TeamId::kBlue, {{-0.3, 0.2}, 0.0}), log) == 1);
  CHECK(given.on(TeamId::kBlue) == 2);
}

TEST_CASE("a robot is put elsewhere at once, and keeps its velocity", "[unit]") {
  SimulatedField field = fieldOf(config());
  run(field, blueAt({20.0, 20.0}), 30);
  const wire::Vision before = field.vision();
  REQUIRE(blue(before, 1).velocity.x > 0.3);
  wire::OddityLog log = quiet();
  // 5/2 of a turn are half a turn.
  CHECK(field.replace(putting(1, TeamId::kBlue, {{0.2, -0.4}, 5.0 * math::kPi}), log) == 1);
  const wire::Vision after = field.vision();
  CHECK(blue(after, 1).pose.position == Vec2{0.2, -0.4});
  CHECK(std::abs(blue(after, 1).pose.heading) == Approx(math::kPi));
  CHECK(blue(after, 1).velocity == blue(before, 1).velocity);
  CHECK(blue(after, 0).pose.position == blue(before, 0).pose.position);
  run(field, blueAt({20.0, 20.0}), 1);
  CHECK(blue(field.vision(), 1).velocity.x > 0.1);  // the wheels turn it only little by little
  run(field, blueAt({20.0, 20.0}), 60);
  CHECK(blue(field.vision(), 1).velocity.x < -0.2);
}

TEST_CASE("a robot that is off is not seen and stands, and its body stays", "[unit]") {
  SimulatedField field = fieldOf(config());
  wire::OddityLog log = quiet();
  field.replace(putting(0, TeamId::kBlue, {{-0.3, 0.4}, 0.0}, false), log);
  CHECK(field.on(TeamId::kBlue) == 6);
  CHECK(field.wentOff(TeamId::kBlue) == 1);
  CHECK(field.vision().robots[0].front().number == 1);
  run(field, blueAt({20.0, 20.0}), 60);
  CHECK(field.wentOff(TeamId::kBlue) == 0);
  // A ball rolls against what nobody sees.
  field.replace(rolling({-0.6, 0.4}, {0.5, 0.0}), log);
  run(field, kStill, 120);
  CHECK(field.vision().ball.position.x < -0.3);
  field.replace(putting(0, TeamId::kBlue, {{-0.3, 0.4}, 0.0}), log);
  run(field, blueAt({20.0, 20.0}), 30);
  CHECK(blue(field.vision(), 0).pose.position.x > -0.28);
}

TEST_CASE("a ball gets its place and velocity, and no spin", "[unit]") {
  SimulatedField field = fieldOf(config());
  wire::OddityLog log = quiet();
  CHECK(field.replace(rolling({0.0, 0.3}, {1.0, 0.0}), log) == 1);
  CHECK(field.vision().ball.velocity == Vec2{1.0, 0.0});
  CHECK(field.vision().ball.spin == Vec2{});
  run(field, kStill, 12);
  const double slid = field.vision().ball.velocity.x;
  CHECK(slid < 0.85);  // it slides until it rolls, which takes it three tenths
  field.replace(rolling({0.0, 0.3}, {1e300, 0.0}), log);
  run(field, kStill, 60);
  CHECK(isFinite(field.vision().ball.position));
  field.replace(rolling({0.0, 0.3}, {900.0, 0.0}), log);
  run(field, kStill, 60);
  CHECK(std::abs(field.vision().ball.position.x) < 0.9);
}

TEST_CASE("what is not finite or not there moves nothing and is noted", "[unit]") {
  SimulatedField field = fieldOf(config());
  wire::OddityLog log = quiet();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(field.replace(putting(0, TeamId::kBlue, {{nan, 0.0}, 0.0}), log) == 0);
  CHECK(field.replace(putting(0, TeamId::kBlue, {{0.0, 0.0}, infinity}, false), log) == 0);
  CHECK(field.replace(putting(3, TeamId::kYellow, {{0.0, 0.0}, 0.0}), log) == 0);
  CHECK(field.replace(rolling({0.0, 0.0}, {0.0, -infinity}), log) == 0);
  CHECK(log.count(Oddity::kNotFinite) == 3);
  CHECK(log.count(Oddity::kUnknown) == 1);
  CHECK(field.on(TeamId::kBlue) == 7);
  CHECK(blue(field.vision(), 0).pose.position.x == Approx(-0.675).margin(0.01));
}

TEST_CASE("overlaps are pushed apart, the same way each time", "[unit]") {
  const auto ended = [] {
    SimulatedField field = fieldOf(config());
    wire::OddityLog log = quiet();
    for (std::uint32_t i = 0; i < 3; ++i) {
      field.replace(putting(i, TeamId::kBlue, {{0.3, 0.1}, 0.0}), log);
      field.replace(putting(i, TeamId::kYellow, {{0.749, 0.649}, 0.5}), log);  // in a corner
    }
    field.replace(rolling({0.3, 0.1}, {}), log);
    run(field, kStill, 120);
    // Another replacement builds a world of what the engine made of it.
    field.replace(rolling({-0.3, 0.1}, {}), log);
    run(field, kStill, 1);
    return field.vision();
  };
  const wire::Vision once = ended(), again = ended();
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Pose2& pose = once.robots[indexOf(team)][i].state.pose;
      CHECK(pose.position == again.robots[indexOf(team)][i].state.pose.position);
      CHECK(norm(pose.position) < 1.2);
      CHECK(norm(once.robots[indexOf(team)][i].state.velocity) < 0.1);
    }
  }
  CHECK(distance(blue(once, 0).pose.position, blue(once, 1).pose.position) > 0.07);
}

TEST_CASE("whatever is put wherever, the world takes it", "[unit]") {
  SimulatedField field = fieldOf(config());
  wire::OddityLog log = quiet();
  Rng random(1, Stream::kWheelCommands);
  const auto somewhere = [&] { return Vec2{random.uniform(-0.95, 0.95), random.uniform(-0.75, 0.75)}; };
  for (int i = 0; i < 400; ++i) {
    const TeamId team = i % 2 == 0 ? TeamId::kBlue : TeamId::kYellow;
    const auto number = static_cast<std::uint32_t>(i / 2 % 3);
    field.replace(putting(number, team, {somewhere(), random.uniform(-1e3, 1e3)}, i % 7 != 0), log);
    if (i % 3 == 0) field.replace(rolling(somewhere(), somewhere() * 80.0), log);
    run(field, blueAt({random.uniform(-200.0, 200.0), random.uniform(-200.0, 200.0)}), 10);
  }
  CHECK(isFinite(field.vision().ball.position));
}

TEST_CASE("what is put outside of the walls stands there until it is put elsewhere", "[unit]") {
  SimulatedField field = fieldOf(config());
  wire::OddityLog log = quiet();
  // Where the league's referee program puts robots in a shoot-out.
  CHECK(field.replace(putting(2, TeamId::kBlue, {{-0.3, 0.715}, 1.5}), log) == 1);
  CHECK(field.replace(rolling({0.0, 1.0}, {1.0, 0.0}), log) == 1);
  run(field, blueAt({20.0, 20.0}), 30);
  CHECK(blue(field.vision(), 2).pose.position == Vec2{-0.3, 0.715});
  CHECK(blue(field.vision(), 2).velocity == Vec2{});
  CHECK(field.vision().ball.position == Vec2{0.0, 1.0});
  CHECK(blue(field.vision(), 0).velocity.x > 0.3);
  field.replace(putting(2, TeamId::kBlue, {{-0.3, 0.3}, 0.0}), log);
  run(field, blueAt({20.0, 20.0}), 30);
  CHECK(blue(field.vision(), 2).velocity.x > 0.3);
}

}  // namespace fulbito::simulator
