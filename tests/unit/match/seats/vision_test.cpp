#include "match/seats/vision.hpp"

#include <cmath>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kDt = 1.0 / 60.0;

/// One robot that drives a circle and a ball that rolls straight, without physics.
WorldState pictureAt(Tick tick) {
  const double t = static_cast<double>(tick) * kDt;
  WorldState world;
  world.tick = tick;
  RobotState robot;
  robot.pose = {math::unit(0.5 * t) * 0.5, math::wrapAngle(0.5 * t + math::kPi / 2)};
  robot.velocity = perp(math::unit(0.5 * t)) * 0.25;
  robot.angular_velocity = 0.5;
  world.robots.push_back(robot);
  BallState ball;
  ball.position = {-0.5 + 0.001 * static_cast<double>(tick), 0.1};
  ball.velocity = {0.06, 0.0};
  world.balls.push_back(ball);
  return world;
}

struct Spread {
  double sum = 0.0, squares = 0.0;
  int n = 0;
  void add(double x) { sum += x, squares += x * x, ++n; }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt(squares / n - mean() * mean()); }
};

}  // namespace

TEST_CASE("latency shows the exact picture of so many ticks ago, at first the start", "[unit]") {
  VisionModel model;
  model.latency_ticks = 4;
  Vision vision(model, 1, TeamId::kBlue, kDt);
  vision.reset(pictureAt(0));
  for (Tick tick = 0; tick < 50; ++tick) {
    const Sight& sight = vision.see(pictureAt(tick));
    const WorldState then = pictureAt(std::max<Tick>(tick - 4, 0));
    CHECK(sight.robots[0].pose.position == then.robots[0].pose.position);
    CHECK(sight.robots[0].velocity == then.robots[0].velocity);
    CHECK(sight.ball.position == then.balls[0].position);
  }
  vision.reset(pictureAt(1000));
  CHECK(vision.see(pictureAt(1000)).ball.position == pictureAt(1000).balls[0].position);
}

TEST_CASE("noise has the wanted size and no bias, and velocities the filter's", "[unit]") {
  VisionModel model;
  model.position_noise = 0.002;
  model.heading_noise = 0.03;
  Vision vision(model, 1, TeamId::kBlue, kDt);
  vision.reset(pictureAt(0));
  Spread x, y, heading, speed, yaw, ball_x, ball_speed;
  for (Tick tick = 1; tick < 20000; ++tick) {
    const WorldState truth = pictureAt(tick);
    const Sight& sight = vision.see(truth);
    if (tick < 60) continue;
    const RobotState &seen = sight.robots[0], &is = truth.robots[0];
    x.add(seen.pose.position.x - is.pose.position.x);
    y.add(seen.pose.position.y - is.pose.position.y);
    heading.add(math::wrapAngle(seen.pose.heading - is.pose.heading));
    speed.add(seen.velocity.x - is.velocity.x);
    yaw.add(seen.angular_velocity - is.angular_velocity);
    ball_x.add(sight.ball.position.x - truth.balls[0].position.x);
    ball_speed.add(sight.ball.velocity.x - truth.balls[0].velocity.x);
  }
  for (const Spread& place : {x, y, ball_x}) {
    CHECK(place.deviation() == Approx(0.002).epsilon(0.03));
    CHECK(std::abs(place.mean()) < 1e-4);
  }
  CHECK(heading.deviation() == Approx(0.03).epsilon(0.03));
  CHECK(std::abs(heading.mean()) < 1e-3);
  // The variance of a g-h filter's rate for white noise: 2 h^2 / (g (4 - 2 g - h)) of sigma^2 / dt^2.
  const double rate = std::sqrt(2 * 0.17157 * 0.17157 / (0.5 * (4 - 1 - 0.17157))) / kDt;
  CHECK(ball_speed.deviation() == Approx(0.002 * rate).epsilon(0.05));
  CHECK(speed.deviation() == Approx(0.002 * rate).epsilon(0.05));
  CHECK(yaw.deviation() == Approx(0.03 * rate).epsilon(0.05));
  CHECK(std::abs(ball_speed.mean()) < 0.001);
  CHECK(std::abs(yaw.mean()) < 0.02);
}

TEST_CASE("a body that drops out stays where it was seen last, without noise the truth", "[unit]") {
  VisionModel model;
  model.dropout = 0.3;
  Vision vision(model, 1, TeamId::kBlue, kDt);
  vision.reset(pictureAt(0));
  int stale = 0;
  Vec2 last = pictureAt(0).balls[0].position;
  for (Tick tick = 1; tick <= 10000; ++tick) {
    const WorldState truth = pictureAt(tick);
    const Vec2 ball = vision.see(truth).ball.position;
    CHECK((ball == truth.balls[0].position || ball == last));
    stale += ball == last ? 1 : 0;
    last = ball;
  }
  CHECK(stale == Approx(3000).margin(200));
}

TEST_CASE("with noise and drop-outs a steady motion is still tracked without bias", "[unit]") {
  VisionModel model;
  model.position_noise = 0.001;
  model.dropout = 0.5;
  Vision vision(model, 3, TeamId::kYellow, kDt);
  vision.reset(pictureAt(0));
  Spread speed;
  for (Tick tick = 1; tick < 20000; ++tick) speed.add(vision.see(pictureAt(tick)).ball.velocity.x - 0.06);
  CHECK(std::abs(speed.mean()) < 0.001);
  CHECK(speed.deviation() < 0.02);
}

TEST_CASE("what is seen is reproducible and belongs to the seat and the seed", "[unit]") {
  VisionModel model;
  model.position_noise = 0.002;
  const auto firstX = [&](std::uint64_t seed, TeamId seat) {
    Vision vision(model, seed, seat, kDt);
    vision.reset(pictureAt(0));
    return vision.see(pictureAt(1)).ball.position.x;
  };
  CHECK(firstX(1, TeamId::kBlue) == firstX(1, TeamId::kBlue));
  CHECK(firstX(1, TeamId::kBlue) != firstX(1, TeamId::kYellow));
  CHECK(firstX(1, TeamId::kBlue) != firstX(2, TeamId::kBlue));
}

TEST_CASE("matches with an imperfect vision are reproducible and differ from those without", "[unit]") {
  MatchConfig config = shortMatch();
  const std::uint64_t perfect = hashOf(config);
  for (VisionModel& seat : config.vision) seat.latency_ticks = 3;
  const std::uint64_t late = hashOf(config);
  for (VisionModel& seat : config.vision) seat.position_noise = 0.002;
  for (VisionModel& seat : config.vision) seat.heading_noise = 0.02;
  for (VisionModel& seat : config.vision) seat.dropout = 0.05;
  const std::uint64_t blurred = hashOf(config);
  CHECK(late != perfect);
  CHECK(blurred != late);
  CHECK(hashOf(config) == blurred);
  config.seed = 2;
  CHECK(hashOf(config) != blurred);
}

TEST_CASE("one team may see worse than the other", "[unit]") {
  PerTeam<Tick> first{};
  PerTeam<TestEntry> entries{TestEntry([&](const Observation& seen) {
                               first[0] = std::min(first[0], seen.tick);
                               return allWheels({20.0, 20.0});
                             }),
                             TestEntry([&](const Observation& seen) {
                               first[1] = std::min(first[1], seen.tick);
                               return allWheels({20.0, 20.0});
                             })};
  MatchConfig config = shortMatch();
  config.teams = {entries[0].choice(), entries[1].choice()};
  config.vision[1].latency_ticks = 7;
  auto match = Match::create(config);
  REQUIRE(match);
  for (int i = 0; i < 10; ++i) REQUIRE(match->step());
  CHECK(first == PerTeam<Tick>{0, -7});
}

TEST_CASE("teams see the age of their pictures", "[unit]") {
  std::vector<Tick> ticks;
  std::vector<Vec2> places;
  const TestEntry entry([&](const Observation& observation) {
    ticks.push_back(observation.tick);
    places.push_back(observation.own[0].state.pose.position);
    return allWheels({20.0, 20.0});
  });
  MatchConfig config = shortMatch();
  config.teams[0] = entry.choice();
  config.start = twoColumns();
  for (VisionModel& seat : config.vision) seat.latency_ticks = 5;
  auto match = Match::create(config);
  REQUIRE(match);
  std::vector<Vec2> truth;
  for (int i = 0; i < 15; ++i) {
    truth.push_back(match->world().robots[0].pose.position);
    match->step();
  }
  CHECK(ticks.front() == -5);
  CHECK(ticks.back() == 9);
  CHECK(places[5] == truth[0]);
  CHECK(places[14] == truth[9]);
  CHECK_FALSE(truth[9] == truth[0]);
}

}  // namespace fulbito
