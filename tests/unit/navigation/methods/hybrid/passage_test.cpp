#include "navigation/methods/hybrid/passage.hpp"

#include <limits>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;
constexpr double kScale = 0.241;  // of that robot

/// A gap of 1.3 robot widths at x = 0.1 along the x axis, with edges known to a few millimetres.
class Gap {
 public:
  Gap() {
    for (double side : {1.0, -1.0}) {
      circles.start({.surface = {0.1, side * 0.04875},
                     .inward = {0.0, side},
                     .radius = 0.0375,
                     .spread = 0.003,
                     .deep = 0.003,
                     .across = 0.003},
                    0);
    }
    scene.robot = &kRobot;
  }
  /// Whether the guide leads the robot, after a tick at that pose.
  bool leads(const Pose2& pose, bool may_start = true) {
    scene.self.pose = pose;
    const Vec2 ahead = math::unit(pose.heading);
    const NarrowGap gap{intoFrame(ahead, Vec2{0.1, 0.04875} - pose.position),
                        intoFrame(ahead, Vec2{0.1, -0.04875} - pose.position)};
    guide.update(circles, hits(pose), {&gap, 1}, scene, 0.2, may_start);
    return guide.isActive();
  }
  EchoCircles circles{EchoCircles::Settings{}};
  NavigationScene scene;
  PassageGuide guide;
  std::vector<Vec2> echoes;  ///< what stands elsewhere, world frame

 private:
  std::vector<SectorHit> hits(const Pose2& pose) const {
    std::vector<SectorHit> seen(1, {std::numeric_limits<double>::infinity(), {}});
    for (const Vec2 echo : echoes) {
      const Vec2 place = intoFrame(math::unit(pose.heading), echo - pose.position);
      seen.push_back({norm(place), place});
    }
    return seen;
  }
};

}  // namespace

TEST_CASE("a passage is as wide as the room between two circles, and runs straight through", "[unit]") {
  Gap gap;
  const Passage passage = passageBetween(*gap.circles.named(1), *gap.circles.named(2));
  CHECK(passage.width == Approx(0.0975));
  CHECK(distance(passage.middle, {0.1, 0.0}) < 1e-9);
  CHECK(distance(passage.axis, {1.0, 0.0}) < 1e-9);
  CHECK(passage.deviation == Approx(0.003 * std::sqrt(2.0)));
  CHECK(passage.along({0.0, 0.02}) == Approx(-0.1));
  CHECK(passage.aside({0.0, 0.02}) == Approx(0.02));
}

TEST_CASE("the guide begins right before a gap only", "[unit]") {
  CHECK(Gap().leads({{0.0, 0.01}, 0.2}));
  CHECK_FALSE(Gap().leads({{0.0, 0.01}, 0.2}, false));
  CHECK_FALSE(Gap().leads({{0.0, 0.06}, 0.0}));   // too far aside
  CHECK_FALSE(Gap().leads({{-0.15, 0.0}, 0.0}));  // too early
  CHECK_FALSE(Gap().leads({{0.0, 0.01}, 1.3}));   // turned away
  CHECK_FALSE(Gap().leads({{0.11, 0.0}, 0.0}));   // past it
}

TEST_CASE("the guide leads along the axis until the rear corners are out", "[unit]") {
  Gap gap;
  REQUIRE(gap.leads({{0.0, 0.01}, 0.0}));
  CHECK(gap.guide.direction({0.0, 0.01}, kScale) == Approx(-math::atan2(0.01, 0.25 * kScale)).margin(1e-9));
  CHECK(gap.leads({{0.1, 0.0}, 0.0}));
  CHECK(gap.guide.direction({0.1, 0.0}, kScale) == Approx(0.0).margin(1e-9));
  CHECK(gap.leads({{0.15, 0.0}, 0.0}));
  CHECK_FALSE(gap.leads({{0.153, 0.0}, 0.0}));
}

TEST_CASE("the guide leads nowhere where something stands in the way out", "[unit]") {
  const Pose2 pose{{0.0, 0.0}, 0.0};
  const auto leads = [&](Vec2 echo) {
    Gap gap;
    gap.echoes = {echo};
    return gap.leads(pose);
  };
  CHECK_FALSE(leads({0.16, -0.02}));
  CHECK(leads({0.16, -0.035}));  // an edge
  CHECK(leads({0.20, -0.02}));   // behind where the robot is out
  CHECK(leads({-0.01, 0.01}));   // behind the robot
  Gap gap;
  REQUIRE(gap.leads(pose));
  gap.echoes = {{0.16, 0.0}};
  CHECK_FALSE(gap.leads(pose));
}

TEST_CASE("the guide gives up where a circle goes", "[unit]") {
  Gap gap;
  REQUIRE(gap.leads({{0.0, 0.0}, 0.0}));
  gap.circles.reset();
  CHECK_FALSE(gap.leads({{0.01, 0.0}, 0.0}));
}
