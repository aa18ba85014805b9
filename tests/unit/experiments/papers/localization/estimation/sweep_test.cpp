#include "experiments/papers/localization/estimation/sweep.hpp"

#include <cmath>
#include <vector>

#include "fulbito/detail/echo_scene.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::localization;
using namespace fulbito::test;

namespace {

constexpr double kDegree = math::kPi / 180;
constexpr SweepSensor kSensor{12.5 * kDegree, 0.22, 170.0, 0.008};

/// Echoes of a sweep in a room [0, 4] x [0, 3] by exact cone casts, with noise.
std::vector<SweepEcho> sweepAt(Vec2 place, double centre, double half, double noise, Rng& random) {
  EchoScene scene;
  const std::vector<Vec2> room{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  scene.addRoom(room);
  std::vector<SweepEcho> echoes;
  for (double heading = centre - half; heading <= centre + half; heading += 2 * kDegree) {
    const Vec2 axis = math::unit(heading);
    const Echo echo = scene.castCone({place + axis * kSensor.reach, axis, kSensor.cone, 6.0}, 30 * kDegree);
    SweepEcho taken{heading, {}};
    if (echo.isHeard()) taken.time = (echo.distance + random.normal(0.0, noise)) / kSensor.echo_speed;
    echoes.push_back(taken);
  }
  return echoes;
}

double squared(double value) { return value * value; }

struct Errors {
  double shortest = 0.0, level = 0.0, fitted = 0.0;  // [deg] rms
};

/// Errors of sweeps by +-40 degrees toward the wall x = 4, with centres up to `off` away.
Errors errorsOf(Vec2 place, double off, double noise) {
  Rng random(4, kTestStream);
  constexpr int kRuns = 300;
  Errors sums;
  for (int run = 0; run < kRuns; ++run) {
    const auto sweep = sweepAt(place, random.uniform(-off, off) * kDegree, 40 * kDegree, noise, random);
    const double level = *levelCentre(sweep, kSensor);
    sums.shortest += squared(*shortestEcho(sweep) / kDegree) / kRuns;
    sums.level += squared(level / kDegree) / kRuns;
    sums.fitted += squared(fittedPerpendicular(sweep, level, kSensor) / kDegree) / kRuns;
  }
  return {std::sqrt(sums.shortest), std::sqrt(sums.level), std::sqrt(sums.fitted)};
}

}  // namespace

TEST_CASE("the shortest echo is a draw over the cone, the middle and the fit are not", "[unit]") {
  const Errors errors = errorsOf({2.5, 1.5}, 8.0, 0.008);
  CHECK(errors.shortest > 4.0);
  CHECK(errors.level < 1.5);
  CHECK(errors.fitted < 0.5);
}

TEST_CASE("without noise the middle and the fit are exact to the sweep's step", "[unit]") {
  Rng random(5, kTestStream);
  for (const double off : {-7.0, 0.0, 3.3}) {
    const auto sweep = sweepAt({2.5, 1.5}, off * kDegree, 40 * kDegree, 0.0, random);
    const double level = *levelCentre(sweep, kSensor);
    CHECK(std::abs(level) < 1.1 * kDegree);
    CHECK(std::abs(fittedPerpendicular(sweep, level, kSensor)) < 0.1 * kDegree);
  }
}

TEST_CASE("a near wall beside hides a flank, which the fit stands and the middle does not", "[unit]") {
  const Errors errors = errorsOf({1.6, 0.45}, 6.0, 0.008);
  CHECK(errors.level > 1.5);
  CHECK(errors.fitted < 0.6);
}

TEST_CASE("of two walls in a sweep the nearer one counts", "[unit]") {
  Rng random(7, kTestStream);
  const auto sweep = sweepAt({1.6, 0.45}, -40 * kDegree, 45 * kDegree, 0.008, random);
  CHECK(*levelCentre(sweep, kSensor) < -55 * kDegree);  // toward y = 0, not x = 4
}

TEST_CASE("a second sweep of +-15 degrees lies within the plateau and gives back its own middle", "[unit]") {
  Rng random(6, kTestStream);
  const auto sweep = sweepAt({2.5, 1.5}, 6 * kDegree, 15 * kDegree, 0.0, random);
  CHECK(*levelCentre(sweep, kSensor) == Approx(6 * kDegree).margin(0.5 * kDegree));
}

TEST_CASE("a sweep without echoes has no direction", "[unit]") {
  const std::vector<SweepEcho> silence{{0.0, {}}, {0.1, {}}};
  CHECK_FALSE(shortestEcho(silence));
  CHECK_FALSE(levelCentre(silence, kSensor));
  CHECK_FALSE(levelCentre({}, kSensor));
}
