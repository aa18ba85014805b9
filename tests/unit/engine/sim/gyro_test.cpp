#include <cmath>

#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kTick = 0.05;  // [s]

Gyro gyro(const GyroModel& model, std::uint64_t index = 0) { return {model, Rng(2, kTestStream, index)}; }

}  // namespace

TEST_CASE("a perfect gyro gives the mean rate of a tick", "[unit]") {
  Gyro sensor = gyro({});
  CHECK(sensor.read(0.02, kTick) == Approx(0.4));
  CHECK(sensor.read(-0.02, kTick) == Approx(-0.4));
}

TEST_CASE("scale and bias of a gyro add up", "[unit]") {
  GyroModel model;
  model.scale = 1.01;
  model.bias = 0.02;
  Gyro sensor = gyro(model);
  CHECK(sensor.read(0.05, kTick) == Approx(1.01 + 0.02));
  CHECK(sensor.bias() == 0.02);  // without drift it stays
}

TEST_CASE("a gyro's noise has the stated mean and deviation", "[unit]") {
  GyroModel model;
  model.noise = 0.004;
  Gyro sensor = gyro(model);
  double sum = 0.0, squares = 0.0;
  constexpr int kReadings = 10000;
  for (int i = 0; i < kReadings; ++i) {
    const double rate = sensor.read(0.0, kTick);
    sum += rate;
    squares += rate * rate;
  }
  CHECK(sum / kReadings == Approx(0.0).margin(4 * 0.004 / std::sqrt(kReadings)));
  CHECK(std::sqrt(squares / kReadings) == Approx(0.004).epsilon(0.03));
}

TEST_CASE("a gyro's bias walks with the root of time, whatever the tick", "[unit]") {
  GyroModel model;
  model.bias = 0.01;
  model.drift = 0.001;
  for (const double tick : {0.05, 0.2}) {
    double squares = 0.0;
    constexpr int kRuns = 400;
    for (int run = 0; run < kRuns; ++run) {
      Gyro sensor = gyro(model, static_cast<std::uint64_t>(run));
      for (int i = 0; i < static_cast<int>(16.0 / tick + 0.5); ++i) sensor.read(0.0, tick);
      squares += (sensor.bias() - 0.01) * (sensor.bias() - 0.01);
    }
    CHECK(std::sqrt(squares / kRuns) == Approx(0.001 * 4.0).epsilon(0.12));  // 16 s
  }
}
