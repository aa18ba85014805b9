#include "experiments/papers/localization/estimation/axis_decision.hpp"

#include <cmath>

#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;
using namespace fulbito::localization;

namespace {

constexpr Body kBody{0.44, 0.40};

/// Sum of the side echo times of an aligned robot at a temperature, without noise.
double sideTime(const Room& room, Facing facing, double celsius) {
  return (acrossOf(room, facing) - kBody.width) / (speedOfSound(celsius) / 2);
}

constexpr std::array kFacings{Facing::kMinusY, Facing::kMinusX};
constexpr std::array kTemperatures{5.0, 12.0, 20.0, 28.0, 35.0};

}  // namespace

TEST_CASE("the constant is half the speed of sound: 0.167 to 0.176 mm/us", "[unit]") {
  CHECK(echoSpeedBand().low == Approx(167.16).margin(0.01));
  CHECK(echoSpeedBand().high == Approx(175.94).margin(0.01));
  const Room room{4.0, 3.0};
  for (const double celsius : kTemperatures) {
    const auto axis = decideAxis(room, kBody, sideTime(room, Facing::kMinusY, celsius), 0.005);
    REQUIRE(axis);
    CHECK(axis->facing == Facing::kMinusY);
    CHECK(axis->echo_speed == Approx(speedOfSound(celsius) / 2));  // (2-1)
  }
}

TEST_CASE("the constant follows from the extent across the robot, (2-1) and (2-2)", "[unit]") {
  const Room room{4.0, 3.0};
  const double time = 2.6 / 171.6;  // Ry - w, at 20 degrees
  const auto axis = decideAxis(room, kBody, time, 0.005);
  REQUIRE(axis);
  CHECK(axis->facing == Facing::kMinusX);
  CHECK(axis->echo_speed == Approx(171.6));
}

TEST_CASE("a room is unambiguous when every temperature tells its axes apart", "[unit]") {
  constexpr double kSigma = 0.0025;
  for (const double longer : {2.5, 4.0, 6.0}) {
    const double needed = bandSeparation(longer, kBody, kSigma);
    for (const bool swapped : {false, true}) {
      const auto room = [&](double shorter) {
        return swapped ? Room{shorter, longer} : Room{longer, shorter};
      };
      const Room clear = room(longer - needed - 0.001), unclear = room(longer - needed + 0.001);
      CHECK(checkUnambiguous(clear, kBody, kSigma));
      CHECK_FALSE(checkUnambiguous(unclear, kBody, kSigma));
      for (const Facing facing : kFacings) {
        for (const double celsius : kTemperatures) {
          for (const double noise : {-3.99 * kSigma, 0.0, 3.99 * kSigma}) {
            const double time = sideTime(clear, facing, celsius) + noise / (speedOfSound(celsius) / 2);
            const auto axis = decideAxis(clear, kBody, time, kSigma);
            REQUIRE(axis);
            CHECK(axis->facing == facing);
          }
        }
      }
    }
  }
}

TEST_CASE("an ambiguous room is refused with the difference that it needs", "[unit]") {
  const auto square = checkUnambiguous({3.0, 3.0}, kBody, 0.0025);
  REQUIRE_FALSE(square);
  CHECK(square.error().code == ErrorCode::kBadInput);
  CHECK(square.error().message ==
        "room 3.000 x 3.000 m is ambiguous: its extents differ by 0 mm, but between 5 and 35 degrees echoes "
        "need more than 149 mm");
  const auto either = decideAxis({3.0, 3.0}, kBody, 2.6 / 171.6, 0.0025);
  REQUIRE_FALSE(either);
  CHECK(either.error().message.find("either axis of the room") == 0);
  const auto neither = decideAxis({3.0, 4.0}, kBody, 3.1 / 171.6, 0.0025);
  REQUIRE_FALSE(neither);
  CHECK(neither.error().message.find("no axis of the room") == 0);
}

// Erratum of (2-1) and (2-2): the paper finds the axis with K = 0.170 mm/us before K is known.
TEST_CASE("the nominal constant shifts the seen width by up to 88, 122 and 189 mm at 3, 4 and 6 m",
          "[unit]") {
  for (const auto& [extent, expected] : {std::pair{3.0, 0.088}, {4.0, 0.122}, {6.0, 0.189}}) {
    const Room room{extent, 1.0};
    const double warm = kNominalEchoSpeed * sideTime(room, Facing::kMinusY, 35.0) + kBody.width;
    const double cold = kNominalEchoSpeed * sideTime(room, Facing::kMinusY, 5.0) + kBody.width;
    CHECK(extent - warm == Approx(expected).margin(0.001));
    CHECK(cold - extent == Approx(expected / 2).margin(0.002));  // 1.7 % against 3.4 %
  }
}

TEST_CASE("the nearer extent is right only from twice that shift on", "[unit]") {
  const double needed = nearestSeparation(4.0, kBody);
  CHECK(needed == Approx(0.243).margin(0.001));
  const auto right = [&](const Room& room) {
    for (const Facing facing : kFacings) {
      for (const double celsius : kTemperatures) {
        if (nearestFacing(room, kBody, sideTime(room, facing, celsius)) != facing) return false;
      }
    }
    return true;
  };
  CHECK(right({4.0, 4.0 - needed - 0.001}));
  CHECK_FALSE(right({4.0, 4.0 - needed + 0.001}));
  CHECK_FALSE(right({4.0, 4.0 - 0.130}));  // 122 mm plus noise are not enough
  CHECK(bandSeparation(4.0, kBody, 0.0) < needed);
}
