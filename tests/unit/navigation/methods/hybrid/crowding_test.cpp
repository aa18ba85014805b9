#include "navigation/methods/hybrid/crowding.hpp"

#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const FieldGeometry kWide{.name = "wide", .length = 16.0, .width = 16.0, .goal_width = 0.0, .corner = 0.0};
const CrowdingRule kRule{0.053, 0.19};

bool crowded(const std::vector<DiscObstacle>& discs, const std::optional<FrontOrbit>& orbit = {}) {
  NavigationScene scene;
  scene.field = &kWide;
  scene.obstacles = discs;
  const SectorCircle circle(72);
  std::vector<SectorHit> hits(72);
  scanScene(circle, scene, hits);
  for (SectorHit& hit : hits) {
    if (hit.distance > 0.36) hit = {std::numeric_limits<double>::infinity(), {}};
  }
  return isCrowded(circle, hits, orbit, kRule);
}

}  // namespace

TEST_CASE("two obstacles with a narrow gap are crowded, with a wide one they are not", "[unit]") {
  CHECK(crowded({{{0.2, 0.09}, 0.04, {}}, {{0.2, -0.09}, 0.04, {}}}));
  CHECK_FALSE(crowded({{{0.2, 0.18}, 0.04, {}}, {{0.2, -0.18}, 0.04, {}}}));
  CHECK_FALSE(crowded({{{0.2, 0.0}, 0.04, {}}}));
}

TEST_CASE("a gap beside the robot counts until its rear has left it, one behind does not", "[unit]") {
  CHECK(crowded({{{-0.05, 0.09}, 0.04, {}}, {{-0.05, -0.09}, 0.04, {}}}));
  CHECK_FALSE(crowded({{{-0.3, 0.09}, 0.04, {}}, {{-0.3, -0.09}, 0.04, {}}}));
}

TEST_CASE("an orbit round the obstacle ahead that touches another is crowded", "[unit]") {
  const DiscObstacle ahead{{0.2, 0.0}, 0.04, {}}, far{{0.25, 0.27}, 0.03, {}};
  const FrontOrbit small{{{0.16, 0.0}, {0.16, 0.0}}, 0.06}, large{{{0.16, 0.0}, {0.16, 0.0}}, 0.25};
  CHECK_FALSE(crowded({ahead, far}, small));
  CHECK(crowded({ahead, far}, large));
}
