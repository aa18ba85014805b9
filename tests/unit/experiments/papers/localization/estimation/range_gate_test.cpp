#include "experiments/papers/localization/estimation/range_gate.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;
using namespace fulbito::localization;

namespace {

constexpr Vec2 kAhead{1.0, 0.0};

/// A sensor that drives 30 mm per echo toward a wall at 2 m.
bool next(RangeGate& gate, int step, double error = 0.0) {
  const double x = 0.03 * step;
  return gate.accept(2.0 - x + error, {x, 0.0}, kAhead);
}

}  // namespace

TEST_CASE("echoes that follow the odometry pass from the third on", "[unit]") {
  RangeGate gate(0.03);
  CHECK_FALSE(next(gate, 0));
  CHECK_FALSE(next(gate, 1));
  for (int step = 2; step < 6; ++step) CHECK(next(gate, step));
}

TEST_CASE("a jump is refused, and so are the two echoes that are compared with it", "[unit]") {
  RangeGate gate(0.03);
  for (int step = 0; step < 4; ++step) next(gate, step);
  CHECK_FALSE(next(gate, 4, 0.05));
  CHECK_FALSE(next(gate, 5));
  CHECK_FALSE(next(gate, 6));
  CHECK(next(gate, 7));
}

TEST_CASE("an error up to the limit passes", "[unit]") {
  RangeGate gate(0.03);
  for (int step = 0; step < 4; ++step) next(gate, step);
  CHECK(next(gate, 4, 0.029));
  RangeGate strict(0.03);
  for (int step = 0; step < 4; ++step) next(strict, step);
  CHECK_FALSE(next(strict, 4, 0.031));
}

TEST_CASE("a missing echo is no proof of the next ones", "[unit]") {
  RangeGate gate(0.03);
  for (int step = 0; step < 4; ++step) next(gate, step);
  CHECK_FALSE(gate.accept(std::nullopt, {0.12, 0.0}, kAhead));
  CHECK_FALSE(next(gate, 5));
  CHECK_FALSE(next(gate, 6));
  CHECK(next(gate, 7));
}

TEST_CASE("only the way along the beam counts", "[unit]") {
  RangeGate gate(0.03);
  for (int step = 0; step < 5; ++step) {
    const bool accepted = gate.accept(1.0, {0.0, 0.2 * step}, kAhead);  // along the wall
    CHECK(accepted == (step >= 2));
  }
}
