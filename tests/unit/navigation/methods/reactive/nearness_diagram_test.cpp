#include "navigation/methods/reactive/nearness_diagram.hpp"

#include "fulbito/detail/math.hpp"
#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/navigator_properties.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {
namespace {

constexpr double kBall = 0.0335;
constexpr double kDegree = math::kPi / 180.0;
constexpr double kHalfWidth = 0.0375, kR = kHalfWidth + 0.002, kSecurity = 0.19;

/// A robot at the origin facing along x, far from any wall.
struct OpenFloor {
  FieldGeometry field;
  RobotModel robot = test::paperRobot(1.0);
  std::vector<DiscObstacle> balls;
  NearnessDiagram navigator;
  Guidance guidance;

  explicit OpenFloor(std::vector<Vec2> centres, NearnessDiagramParams params = {}) : navigator(params) {
    field.length = field.width = 10.0;
    for (Vec2 centre : centres) balls.push_back({centre, kBall, {}});
  }
  NearnessMotion decide(Vec2 goal) {
    NavigationScene scene;
    scene.field = &field;
    scene.robot = &robot;
    scene.goal.position = goal;
    scene.obstacles = balls;
    guidance = navigator.plan(scene);
    return navigator.motion();
  }
};

/// Length of a ray at an angle of `degrees` to the centre of a ball at `range`, up to the ball.
double rayOntoBall(double range, double degrees) {
  const double across = range * math::sin(degrees * kDegree);
  return range * math::cos(degrees * kDegree) - std::sqrt(kBall * kBall - across * across);
}

/// y [m] at which a run first crosses the line x = 0.
double crossingOf(const test::KinematicResult& run) {
  for (Vec2 p : run.path) {
    if (p.x >= 0.0) return p.y;
  }
  return 1e9;
}

}  // namespace

TEST_CASE("HSGR: with nothing near, the nearness diagram drives at the goal at full speed", "[unit]") {
  OpenFloor floor({});
  const NearnessMotion motion = floor.decide({0.5, 0.2});
  CHECK(motion.situation == NearnessSituation::kHsgr);
  CHECK(motion.direction == Approx(math::atan2(0.2, 0.5)));
  CHECK(floor.navigator.heading({}) == Approx(math::atan2(0.2, 0.5)));
  CHECK(floor.guidance.speed_cap == Approx(1.0));
}

TEST_CASE("a goal behind the robot is turned to by at most 90 degrees at a time", "[unit]") {
  CHECK(OpenFloor({}).decide({-0.5, 0.2}).direction == Approx(math::kPi / 2));
  CHECK(OpenFloor({}).decide({-0.5, -0.2}).direction == Approx(-math::kPi / 2));
}

TEST_CASE("HSWR: a wide region is entered past its corner by the robot and the security distance", "[unit]") {
  // The ball covers +-5.8 degrees. Sector 6 is the last that it touches, at the sector's edge of 5 degrees.
  OpenFloor floor({{0.33, 0.0}});
  const NearnessMotion left = floor.decide({0.6, 0.01});
  CHECK(left.situation == NearnessSituation::kHswr);
  const double past = math::atan2(kR + kSecurity, rayOntoBall(0.33, 5.0));
  CHECK(left.direction == Approx(8.0 * kDegree + past));
  CHECK(left.speed_share == 1.0);
  CHECK(floor.decide({0.6, -0.01}).direction == Approx(-8.0 * kDegree - past));

  NearnessDiagramParams params;
  params.wide_region = WideRegionRule::kSector;
  CHECK(OpenFloor({{0.33, 0.0}}, params).decide({0.6, 0.01}).direction == Approx((8.0 + 45.0) * kDegree));
}

TEST_CASE("HSNR: a narrow region is entered along its middle", "[unit]") {
  // The second ball covers 34.2 ... 45.8 degrees: sectors 8 ... 32 are free.
  OpenFloor floor({{0.33, 0.0}, math::unit(40.0 * kDegree) * 0.33});
  const NearnessMotion motion = floor.decide({0.6, 0.01});
  CHECK(motion.situation == NearnessSituation::kHsnr);
  CHECK(motion.direction == Approx(20.0 * kDegree));
}

TEST_CASE("LS1: the way past an obstacle bends away from it by what it takes of the security zone",
          "[unit]") {
  // The ball covers +-7.7 degrees. Sector 8 is the last that it touches, at the sector's edge of 7 degrees.
  OpenFloor floor({{0.25, 0.0}});
  const NearnessMotion motion = floor.decide({0.6, 0.01});
  CHECK(motion.situation == NearnessSituation::kLs1);
  const double past = 10.0 * kDegree + math::atan2(kR + kSecurity, rayOntoBall(0.25, 7.0));
  const double c = (0.25 - kBall - kHalfWidth) / kSecurity;
  CHECK(motion.direction == Approx(c * past + (1.0 - c) * math::kPi));
  CHECK(motion.speed_share == Approx(c));
}

TEST_CASE("LSGR: an obstacle beside the way to a visible goal bends it the same way", "[unit]") {
  OpenFloor floor({{0.0, 0.15}});
  const NearnessMotion motion = floor.decide({0.5, 0.0});
  CHECK(motion.situation == NearnessSituation::kLsgr);
  const double c = (0.15 - kBall - kHalfWidth) / kSecurity;
  CHECK(motion.direction == Approx(-(1.0 - c) * math::kPi / 2));
  CHECK(floor.guidance.speed_cap == Approx(c));
}

TEST_CASE("an obstacle farther than a reachable goal is no danger", "[unit]") {
  const NearnessMotion motion = OpenFloor({{0.0, 0.15}}).decide({0.11, 0.0});
  CHECK(motion.situation == NearnessSituation::kHsgr);
  CHECK(motion.direction == Approx(0.0).margin(1e-12));
}

TEST_CASE("LS2: between obstacles the robot turns to the freer side", "[unit]") {
  const double left = (0.15 - kBall - kHalfWidth) / kSecurity;
  const double right = (0.12 - kBall - kHalfWidth) / kSecurity;
  const double turn = (left - right) / (left + right) * math::kPi / 2;
  const NearnessMotion motion = OpenFloor({{0.0, 0.15}, {0.0, -0.12}}).decide({0.5, 0.0});
  CHECK(motion.situation == NearnessSituation::kLs2);
  CHECK(motion.direction == Approx(turn));
  CHECK(motion.speed_share == Approx(right));
  CHECK(OpenFloor({{0.0, 0.12}, {0.0, -0.15}}).decide({0.5, 0.0}).direction == Approx(-turn));
}

TEST_CASE("the two-sided direction reaches 90 degrees at a touch and is unchanged in the middle", "[unit]") {
  CHECK(twoSidedDirection(0.3, {0.5, 0.5, 0.0}) == Approx(0.3));
  CHECK(twoSidedDirection(0.3, {0.0, 0.5, 0.0}) == Approx(-math::kPi / 2));
  CHECK(twoSidedDirection(0.3, {0.5, 0.0, 0.0}) == Approx(math::kPi / 2));
  CHECK(twoSidedDirection(0.3, {0.0, 0.0, 0.0}) == Approx(0.3));
}

TEST_CASE("the one-sided direction is unwrapped to the wanted one before it is weighted", "[unit]") {
  // The direction away from 170 degrees is -10 degrees, 30 degrees from the wanted 20.
  CHECK(oneSidedDirection(20.0 * kDegree, {0.5, 1.0, 170.0 * kDegree}) == Approx(5.0 * kDegree));
  CHECK(oneSidedDirection(170.0 * kDegree, {1.0, 0.5, 10.0 * kDegree}) == Approx(-180.0 * kDegree));
}

TEST_CASE("emergency: with something right in front the robot does not drive", "[unit]") {
  OpenFloor floor({{0.08, 0.0}});
  CHECK(floor.decide({0.6, 0.0}).blocked);
  CHECK(floor.guidance.speed_cap == 0.0);
  CHECK_FALSE(OpenFloor({{0.0, 0.0375 + kBall + 0.005}}).decide({0.6, 0.0}).blocked);
}

TEST_CASE("emergency: a turn that would swing a rear corner into an obstacle is cut", "[unit]") {
  const Vec2 beside{-0.02, kHalfWidth + kBall + 0.003};
  const NearnessMotion cut = OpenFloor({beside}).decide({0.3, -0.1});
  CHECK(cut.turn_cut);
  CHECK(cut.direction == 0.0);
  NearnessDiagramParams params;
  params.margin = 0.004;  // half of it is less than the gap of 3 mm
  const NearnessMotion turn = OpenFloor({beside}, params).decide({0.3, -0.1});
  CHECK_FALSE(turn.turn_cut);
  CHECK(turn.direction < -0.5);
}

TEST_CASE("a robot that is fenced in is stuck and turns in place", "[unit]") {
  std::vector<Vec2> fence;
  for (int k = 0; k < 10; ++k) fence.push_back(math::unit(k * math::kPi / 5) * 0.13);
  OpenFloor floor(fence);
  const NearnessMotion motion = floor.decide({0.5, 0.3});
  CHECK(motion.situation == NearnessSituation::kStuck);
  CHECK(floor.guidance.speed_cap == 0.0);
  CHECK(motion.direction == Approx(math::kPi / 2));
}

TEST_CASE("a gap is navigable from the width 2 R on", "[unit]") {
  const SectorCircle circle(180);
  std::vector<SectorHit> hits(180);
  for (double gap : {0.06, 0.075, 0.085, 0.0975}) {
    NavigationScene scene;
    FieldGeometry field;
    scene.field = &field;
    const double y = gap / 2 + kBall;
    const std::vector<DiscObstacle> balls = {{{0.2, y}, kBall, {}}, {{0.2, -y}, kBall, {}}};
    scene.obstacles = balls;
    scanScene(circle, scene, hits);
    NearnessView view;
    view.circle = &circle;
    view.hits = hits;
    view.radius = kR;
    INFO("gap " << gap);
    CHECK(isNavigable(view, {0.4, 0.0}) == (gap >= 2.0 * kR));
  }
}

TEST_CASE("the nearness diagram brakes for what is straight ahead even beyond its range", "[unit]") {
  OpenFloor floor({{0.8, 0.0}});
  floor.robot = test::paperRobot(2.6);
  floor.decide({2.0, 0.0});
  const NearnessDiagramParams params;
  const double room = 0.8 - kBall - kHalfWidth;
  CHECK(floor.guidance.speed_cap == Approx(std::sqrt(2.0 * params.braking * 5.0 * room)));
}

TEST_CASE("the nearness diagram passes a gap of 1.3 to 1.6 robot widths that orbiting fields do not",
          "[unit]") {
  // Fig. 8 of Kim et al. 2006: a row of balls with one gap. The balls' orbits overlap across it.
  for (double share : {1.3, 1.45, 1.6}) {
    const double half_gap = share * 0.075 / 2;
    std::vector<DiscObstacle> balls;
    for (int k = 0; k < 3; ++k) {
      const double y = half_gap + kBall * (1 + 2 * k);
      balls.push_back({{0.0, y}, kBall, {}});
      balls.push_back({{0.0, -y}, kBall, {}});
    }
    NavigationGoal goal;
    goal.position = {0.5, -0.05};
    const auto drive = [&](const char* method) {
      const auto pilot = makePilot(*parseNavigator(method));
      return test::kinematicTrial(**pilot, test::paperRobot(0.6), {}, {{-0.5, 0.08}, 0.0}, goal, balls);
    };
    INFO("gap of " << share << " widths");
    const auto through = drive("nearness-diagram");
    CHECK(through.reached);
    CHECK_FALSE(through.touched);
    CHECK(std::abs(crossingOf(through)) < half_gap);
    for (const char* method : {"limit-cycle", "vector-field:offset=0.10,width=0.05"}) {
      INFO(method);
      const auto other = drive(method);
      const bool passes = other.reached && !other.touched && std::abs(crossingOf(other)) < half_gap;
      CHECK_FALSE(passes);
    }
  }
}

TEST_CASE("the nearness diagram keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("nearness-diagram");
}

TEST_CASE("the nearness diagram is safe on corner layouts", "[unit]") {
  for (double speed : {0.6, 1.0}) {
    test::SurveyTask task;
    task.speed = speed;
    task.runs = 40;
    const test::Survey survey = test::survey("nearness-diagram", task);
    INFO("safe " << survey.safe << " of 40, L " << survey.over_straight);
    CHECK(survey.safe >= 38);
    CHECK(survey.over_straight < 1.13);
  }
}

}  // namespace fulbito
