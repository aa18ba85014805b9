#include "strategies/prediction/foresight.hpp"

#include <algorithm>
#include <deque>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

struct Errors {
  double robot = 0.0;  ///< [m] greatest error
  double heading = 0.0;
  double ball = 0.0;
  double opponent = 0.0;
  double old = 0.0;  ///< [m] error without the prediction
};

/// Two moving robots and a rolling ball, observed `latency` ticks late.
Errors errorsAt(int latency, std::uint64_t seed) {
  MatchInfo info = test::matchInfo();
  info.rules.team_size = 1;
  const double dt = info.physics.controlPeriod();
  info.observation_age = latency * dt;
  Rng rng(seed, test::kTestStream);
  WorldConfig config{info.field, info.physics, {}, {}, {}};
  config.robots.push_back({info.robot, {{0.0, -0.2}, rng.uniform(-3.0, 3.0)}, {}, 0.0});
  config.robots.push_back({info.robot, {{0.4, 0.1}, rng.uniform(-3.0, 3.0)}, {}, 0.0});
  const Vec2 roll = math::unit(rng.uniform(-3.0, 3.0)) * 0.6;
  config.balls.push_back({info.ball, {-0.5, 0.3}, roll, roll});
  World world = std::move(*World::create(config));
  Foresight foresight(info);
  std::deque<WorldState> past{world.state()};
  std::vector<WheelSpeeds> wheels(2);
  Errors worst;
  Observation seen;
  seen.dt = dt;
  seen.team_size = 1;
  for (int tick = 0; tick < 50; ++tick) {
    const WorldState& old = past.front();
    seen.tick = tick - latency;
    seen.since_restart = tick * dt;
    seen.own[0] = {true, old.robots[0]};
    seen.opponents[0] = {true, old.robots[1]};
    seen.ball = old.balls[0];
    seen.ball.spin = {};
    const Observation& now = foresight.update(seen);
    const WorldState& truth = world.state();
    const auto most = [](double& worst_so_far, double value) {
      worst_so_far = std::max(worst_so_far, value);
    };
    most(worst.robot, distance(now.own[0].state.pose.position, truth.robots[0].pose.position));
    most(worst.heading,
         std::abs(math::wrapAngle(now.own[0].state.pose.heading - truth.robots[0].pose.heading)));
    most(worst.opponent, distance(now.opponents[0].state.pose.position, truth.robots[1].pose.position));
    // Just after the start the observation is younger than its stated age.
    if (tick >= latency) most(worst.ball, distance(foresight.ballNow().position, truth.balls[0].position));
    most(worst.old, distance(old.robots[0].pose.position, truth.robots[0].pose.position));
    if (tick % 15 == 0) {
      for (WheelSpeeds& wheel : wheels) wheel = {rng.uniform(5.0, 20.0), rng.uniform(5.0, 20.0)};
    }
    world.step(wheels);
    seen.sent[0] = wheels[0];
    past.push_back(world.state());
    while (past.size() > static_cast<std::size_t>(latency) + 1) past.pop_front();
  }
  return worst;
}

}  // namespace

TEST_CASE("fresh observations are left alone", "[unit]") {
  const Errors errors = errorsAt(0, 1);
  CHECK(errors.robot == 0.0);
  CHECK(errors.heading == 0.0);
  CHECK(errors.ball == 0.0);
  CHECK(errors.old == 0.0);
}

TEST_CASE("old observations are made current", "[unit]") {
  for (const int latency : {2, 6}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Errors errors = errorsAt(latency, seed);
      CAPTURE(latency, seed);
      CHECK(errors.robot < 0.3 * errors.old);
      CHECK(errors.robot < 0.012);
      CHECK(errors.heading < 0.12);
      CHECK(errors.ball < 0.04);
      CHECK(errors.opponent < 0.05);
    }
  }
}

}  // namespace fulbito
