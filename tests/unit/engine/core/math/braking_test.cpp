#include "engine/core/math/braking.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("one that brakes from its stopping speed stops in its way", "[unit]") {
  constexpr double kStep = 1e-5;  // [s]
  for (const double final_speed : {0.0, 0.3}) {
    double speed = stoppingSpeed(5.0, 0.2, final_speed), way = 0.0;
    for (; speed > final_speed; speed -= 5.0 * kStep) way += speed * kStep;
    CHECK(way == Approx(0.2).margin(1e-4));
  }
  CHECK(stoppingSpeed(5.0, 0.0) == 0.0);
}

}  // namespace fulbito
