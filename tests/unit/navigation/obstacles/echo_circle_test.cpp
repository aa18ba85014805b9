#include "navigation/obstacles/echo_circle.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

constexpr Vec2 kCentre{0.3, 0.0};
constexpr double kRadius = 0.05, kNoise = 0.005;

/// A guess 2 cm beside the middle of the face that looks to the origin.
EchoCircle guess(double across = 0.03) {
  return EchoCircle(
      {.surface = {0.25, 0.02}, .inward = {1.0, 0.0}, .radius = 0.045, .spread = 0.015, .across = across});
}

/// Ranges to the true circle from places on an arc of `angle` [rad] about it.
void hear(EchoCircle& circle, Rng& rng, int count, double angle) {
  for (int i = 0; i < count; ++i) {
    const Vec2 sonar = kCentre - math::unit(angle * (2.0 * i / count - 1.0)) * 0.2;
    circle.correct(circle.expect(sonar), 0.2 - kRadius + rng.normal(0.0, kNoise), kNoise);
  }
}

}  // namespace

TEST_CASE("a new circle lies behind its surface, known as well as the start says", "[unit]") {
  const EchoCircle circle = guess();
  CHECK(circle.centre().x == Approx(0.295));
  CHECK(circle.centre().y == Approx(0.02));
  // The radius shifts the centre and not the face.
  CHECK(circle.surfaceDeviation({-1.0, 0.0}) == Approx(0.01));
  CHECK(circle.surfaceDeviation({0.0, 1.0}) == Approx(std::hypot(0.03, 0.015)));
}

TEST_CASE("a range is the distance to the surface; an error across the way makes it longer", "[unit]") {
  const EchoCircle::Expectation expected = guess().expect({0.0, 0.02});
  const double bend = 0.03 * 0.03 / 0.295;
  CHECK(expected.range == Approx(0.25 + bend / 2));
  CHECK(expected.variance == Approx(0.01 * 0.01 + bend * bend / 2));
  CHECK(distance(expected.way, {1.0, 0.0}) < 1e-12);
}

TEST_CASE("the error of a surface falls with the root of the number of echoes", "[unit]") {
  Rng rng(3, Stream::kSonar);
  EchoCircle circle = guess(1e-4);
  hear(circle, rng, 100, 0.0);
  CHECK(circle.surfaceDeviation({-1.0, 0.0}) == Approx(kNoise / 10.0).epsilon(0.1));
  EchoCircle longer = guess(1e-4);
  hear(longer, rng, 400, 0.0);
  CHECK(longer.surfaceDeviation({-1.0, 0.0}) == Approx(kNoise / 20.0).epsilon(0.1));
}

TEST_CASE("ranges from an arc find the surface within three of its standard deviations", "[unit]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed, Stream::kSonar);
    EchoCircle circle = guess();
    hear(circle, rng, 200, 0.8);
    for (double angle : {-0.8, 0.0, 0.8}) {
      const Vec2 normal = -math::unit(angle);
      const double error = dot(circle.centre() - kCentre, normal) + circle.radius() - kRadius;
      CHECK(std::abs(error) < 3.5 * circle.surfaceDeviation(normal));
      CHECK(circle.surfaceDeviation(normal) < 0.002);
    }
  }
}

TEST_CASE("a body that may move is known less well", "[unit]") {
  EchoCircle circle = guess();
  circle.loosen(0.0004);
  CHECK(circle.surfaceDeviation({-1.0, 0.0}) == Approx(std::sqrt(0.0001 + 0.0004)));
}
