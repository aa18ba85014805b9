#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

TEST_CASE("sound is faster in warm air", "[unit]") {
  CHECK(speedOfSound(0.0) == Approx(331.3));
  CHECK(speedOfSound(20.0) == Approx(343.2).margin(0.05));  // textbook value
  CHECK(speedOfSound(5.0) == Approx(334.3).margin(0.05));
  CHECK(speedOfSound(35.0) == Approx(351.9).margin(0.05));
  CHECK(speedOfSound(-300.0) == 0.0);  // below absolute zero: no root of a negative number
}

TEST_CASE("an echo's time is there and back, in whole microseconds", "[unit]") {
  const EchoTimer timer(20.0);
  CHECK(timer.microseconds(1.7160) == 10000);  // 2 * 1.716 m at 343.2 m/s
  CHECK(timer.microseconds(0.0) == 0);
  CHECK(timer.microseconds(-1.0) == 0);
  CHECK(timer.microseconds(3.0) - timer.microseconds(2.9999) <= 1);
}

TEST_CASE("a fixed constant of 170 m/s errs by 79 mm at 0 and by 125 mm at 40 degrees over 3 m", "[unit]") {
  const auto error = [](double celsius) {
    return 170.0 * static_cast<double>(EchoTimer(celsius).microseconds(3.0)) * 1e-6 - 3.0;
  };
  CHECK(error(0.0) == Approx(0.079).margin(0.001));
  CHECK(error(40.0) == Approx(-0.125).margin(0.001));
}
