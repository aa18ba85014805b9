#include "engine/core/models/sensor.hpp"

#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

const Rng kRandom(5, Stream::kSensorNoise);

struct Spread {
  double sum = 0.0, squares = 0.0;
  int n = 0;
  void add(double x) { sum += x, squares += x * x, ++n; }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt(squares / n - mean() * mean()); }
};

}  // namespace

TEST_CASE("a perfect sensor changes nothing", "[unit]") {
  CHECK(SensorModel{}.perfect());
  Sensor sensor({}, kRandom);
  Vec2 place{0.1, 0.2};
  double heading = 4.0;  // not even wrapped
  CHECK(sensor.sees());
  CHECK_FALSE(sensor.blur(place));
  CHECK_FALSE(sensor.blurHeading(heading));
  CHECK(place == Vec2{0.1, 0.2});
  CHECK(heading == 4.0);
}

TEST_CASE("noise and drop-outs are as large as the model says", "[unit]") {
  SensorModel model;
  model.position_noise = 0.003;
  model.heading_noise = 0.2;
  model.dropout = 0.25;
  CHECK_FALSE(model.perfect());
  Sensor sensor(model, kRandom);
  Spread x, y, turn, seen;
  for (int i = 0; i < 20000; ++i) {
    Vec2 place{1.0, -1.0};
    double heading = 3.1;
    REQUIRE(sensor.blur(place));
    REQUIRE(sensor.blurHeading(heading));
    REQUIRE(std::abs(heading) <= math::kPi);
    x.add(place.x - 1.0);
    y.add(place.y + 1.0);
    turn.add(std::remainder(heading - 3.1, 2.0 * math::kPi));
    seen.add(sensor.sees() ? 1.0 : 0.0);
  }
  for (const Spread& place : {x, y}) {
    CHECK(place.deviation() == Approx(0.003).epsilon(0.03));
    CHECK(std::abs(place.mean()) < 1e-4);
  }
  CHECK(turn.deviation() == Approx(0.2).epsilon(0.03));
  CHECK(seen.mean() == Approx(0.75).margin(0.013));
}

TEST_CASE("the heading's noise is the position's over half a body, as far as it means anything", "[unit]") {
  CHECK(headingNoise(0.0, 0.075) == 0.0);
  CHECK(headingNoise(0.003, 0.075) == Approx(0.08));
  CHECK(headingNoise(0.1, 0.001) == kMaxHeadingNoise);
}

TEST_CASE("pictures arrive late, at first the oldest there is", "[unit]") {
  DelayedPictures<int> pictures(3);
  CHECK(pictures.empty());
  for (int i = 0; i < 20; ++i) {
    pictures.take(i);
    CHECK(pictures.shown() == std::max(0, i - 3));
    CHECK(pictures.age() == static_cast<std::size_t>(std::min(i, 3)));
  }
  pictures.fill(100);
  CHECK(pictures.age() == 3);
  for (int i = 0; i < 3; ++i) {
    pictures.take(i);
    CHECK(pictures.shown() == 100);
  }
  pictures.take(3);
  CHECK(pictures.shown() == 0);
}

TEST_CASE("a sensor model out of its ranges is refused", "[unit]") {
  const auto refusal = [](auto change) {
    SensorModel model;
    change(model);
    return validate(model).error().message;
  };
  CHECK(validate(SensorModel{60, 0.1, 6.28, 0.99}));
  CHECK(refusal([](SensorModel& m) { m.latency_ticks = -1; }) == "latency: -1 is outside 0 ... 60 ticks");
  CHECK(refusal([](SensorModel& m) { m.position_noise = 0.2; }) == "noise: 0.2 is outside 0 ... 0.1 m");
  CHECK(refusal([](SensorModel& m) { m.heading_noise = 7.0; }) ==
        "heading noise: 7 is outside 0 ... 6.283 rad");
  CHECK(refusal([](SensorModel& m) { m.dropout = std::numeric_limits<double>::quiet_NaN(); }) ==
        "dropout: nan is outside 0 ... 0.99");
}

}  // namespace fulbito
