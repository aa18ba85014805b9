#include "strategies/ball_prediction.hpp"

#include <algorithm>
#include <vector>

#include "engine/core/math.hpp"
#include "engine/core/presets.hpp"
#include "engine/core/random.hpp"
#include "engine/sim/world.hpp"
#include "strategies/ball_tracker.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

struct Setting3v3 {
  FieldGeometry field = *loadField("vsss-3v3");
  RobotPreset preset = *loadRobot("vsss");
  PhysicsProfile physics = *loadPhysics("standard");
  BallCourse course{field, preset.ball, physics};
};

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0
                        : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Errors [m] one second ahead, by bounces before.
std::array<std::vector<double>, 3> errorsOneSecondAhead(const Setting3v3& s, double spin_share) {
  std::array<std::vector<double>, 3> errors;
  Rng rng(4, Stream::kTest);
  for (int i = 0; i < 600; ++i) {
    BallState ball;
    do {
      ball.position = {rng.uniform(-0.8, 0.8), rng.uniform(-0.62, 0.62)};
    } while (!s.course.walls.isFree(ball.position));
    ball.velocity = math::unit(rng.uniform(-math::kPi, math::kPi)) * rng.uniform(0.05, 1.6);
    ball.spin = ball.velocity * spin_share;
    WorldConfig config{s.field, s.physics, {}, {}, {}};
    config.balls.push_back({s.preset.ball, ball.position, ball.velocity, ball.spin});
    World world = *World::create(config);
    for (int tick = 0; tick < 60; ++tick) world.step({});
    BallPrediction prediction;
    prediction.predict(s.course, ball);
    const int bounces = prediction.bouncesBefore(1.0);
    errors[static_cast<std::size_t>(std::min(bounces, 2))].push_back(
        distance(prediction.positionAt(1.0), world.state().balls.front().position));
  }
  return errors;
}

}  // namespace

TEST_CASE("the ball is foreseen one second ahead", "[unit]") {
  const Setting3v3 s;
  for (const double spin_share : {1.0, 0.0}) {
    const auto errors = errorsOneSecondAhead(s, spin_share);
    for (std::size_t bounces = 0; bounces < 3; ++bounces) {
      WARN("spin " << spin_share << ", " << bounces << " bounces, " << errors[bounces].size()
                   << " balls: median " << 1000 * percentile(errors[bounces], 0.5) << " mm, 95 % "
                   << 1000 * percentile(errors[bounces], 0.95) << " mm, worst "
                   << 1000 * percentile(errors[bounces], 1.0) << " mm");
    }
    CHECK(percentile(errors[0], 1.0) < 0.02);  // the bars of drill 5
    CHECK(percentile(errors[1], 0.95) < 0.05);
  }
}

}  // namespace fulbito
