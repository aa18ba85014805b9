#include "navigation/methods/hybrid/room_to_turn.hpp"

#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

constexpr double kDegree = math::kPi / 180.0;
const NearnessHull kHull{0.075, 0.075, 0.01};

std::vector<SectorHit> pointAt(Vec2 p) { return {{norm(p), p}}; }

}  // namespace

TEST_CASE("a body without obstacles turns as it wants", "[unit]") {
  CHECK(roomToTurn({}, kHull, 1.2) == 1.2);
  CHECK(roomToTurn(pointAt({0.2, 0.0}), kHull, -3.0) == -3.0);
}

TEST_CASE("a rear corner does not swing into what stands beside it", "[unit]") {
  // 12 mm to the right of the rear: a turn to the left would bring the corner there.
  const auto beside = pointAt({-0.035, -0.0495});
  const double left = roomToTurn(beside, kHull, 45.0 * kDegree);
  CHECK(left < 5.0 * kDegree);
  CHECK(left >= 0.0);
  CHECK(roomToTurn(beside, kHull, -20.0 * kDegree) == Approx(-20.0 * kDegree));
  // Mirrored, the other turn is cut.
  CHECK(roomToTurn(pointAt({-0.035, 0.0495}), kHull, -45.0 * kDegree) == Approx(-left));
}

TEST_CASE("a body that is too near already may turn away", "[unit]") {
  const auto near = pointAt({0.03, -0.039});
  CHECK(roomToTurn(near, kHull, 20.0 * kDegree) == Approx(20.0 * kDegree));
  CHECK(roomToTurn(near, kHull, -20.0 * kDegree) == 0.0);
}
