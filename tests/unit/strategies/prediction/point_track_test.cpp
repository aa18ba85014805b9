#include "strategies/prediction/point_track.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr double kDt = 1.0 / 60.0;
constexpr double kNoise = 0.002;  // [m]

Vec2 blurred(Rng& rng, Vec2 p) { return p + Vec2{rng.normal(), rng.normal()} * kNoise; }

}  // namespace

TEST_CASE("a track of a straight motion is better than its noisy positions", "[unit]") {
  Rng rng(3, test::kTestStream);
  PointTrack track(kNoise);
  const Vec2 velocity{0.4, -0.3};
  double position_square = 0.0, velocity_square = 0.0;
  constexpr int kTicks = 3000;
  for (int i = 0; i < kTicks; ++i) {
    const Vec2 truth = velocity * (i * kDt);
    track.update(blurred(rng, truth), velocity, {}, kDt);
    position_square += squaredNorm(track.position() - truth) / 2;
    velocity_square += squaredNorm(track.velocity() - velocity) / 2;
  }
  CHECK(std::sqrt(position_square / kTicks) < 0.75 * kNoise);
  // The camera's own filter has 0.2 of the noise per tick.
  CHECK(std::sqrt(velocity_square / kTicks) < 0.12 * kNoise / kDt);
}

TEST_CASE("a track follows a kick at once", "[unit]") {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Rng rng(seed, test::kTestStream);
    PointTrack track(kNoise);
    for (int i = 0; i < 60; ++i) track.update(blurred(rng, {}), {}, {}, kDt);
    Vec2 truth;
    for (int i = 0; i < 4; ++i) {
      truth += Vec2{1.0, 0.0} * kDt;
      track.update(blurred(rng, truth), {}, {}, kDt);
    }
    CHECK(distance(track.position(), truth) < 3.0 * kNoise);
    CHECK(distance(track.velocity(), {1.0, 0.0}) < 0.15);
  }
}

TEST_CASE("a track continues while the camera repeats its last picture", "[unit]") {
  PointTrack track(kNoise);
  track.update({}, {0.6, 0.0}, {}, kDt);
  for (int i = 0; i < 3; ++i) track.update({}, {0.6, 0.0}, {}, kDt);
  CHECK(track.position().x == Approx(0.6 * 3 * kDt));
  CHECK(track.velocity().x == Approx(0.6));
}

}  // namespace fulbito
