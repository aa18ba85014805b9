#include "navigation/methods/paths/tangent_graph.hpp"

#include "fulbito/detail/math.hpp"
#include "fulbito/navigation.hpp"
#include "navigation/obstacles/path_problem.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {
namespace {

/// One robot, some obstacles, and the objects to which a scene points.
struct Setup {
  FieldGeometry field;
  RobotModel robot = test::paperRobot(1.0);
  std::vector<DiscObstacle> obstacles;
  NavigationScene scene;

  NavigationScene& at(Vec2 start, Vec2 goal) {
    scene.field = &field;
    scene.robot = &robot;
    scene.obstacles = obstacles;
    scene.self.pose.position = start;
    scene.goal.position = goal;
    return scene;
  }
};

}  // namespace

TEST_CASE("tangent-graph keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("tangent-graph");
}

TEST_CASE("the tangent path passes an obstacle at the robot's radius and the margin", "[unit]") {
  Setup setup;
  setup.obstacles = {{{0.0, 0.01}, 0.0335, {}}};
  const NavigationScene& scene = setup.at({-0.5, 0.0}, {0.5, 0.0});
  std::vector<Circle> bodies;
  predictObstacles(scene, 0.5, bodies);
  TangentPath path;
  CHECK(path.plan(scene, bodies) == TangentPath::Outcome::kFound);
  REQUIRE(path.passes().size() == 1);
  CHECK(path.passes()[0].side == 1);  // below it: the obstacle on the left
  CHECK(path.passes()[0].radius == Approx(0.0335 + setup.robot.circumradius() + 0.005));
  CHECK(path.speedCap(scene) > 1e9);
}

TEST_CASE("a gap narrower than the circumscribed circle is passed straight, none is reported", "[unit]") {
  Setup setup;
  const double radius = 0.05;
  const auto gate = [&](double gap) {
    setup.obstacles.clear();
    for (double y = gap / 2 + radius; y < 0.8; y += 0.09) {
      setup.obstacles.push_back({{0.0, y}, radius, {}});
      setup.obstacles.push_back({{0.0, -y}, radius, {}});
    }
    const NavigationScene& scene = setup.at({-0.5, 0.0}, {0.5, 0.0});
    std::vector<Circle> bodies;
    predictObstacles(scene, 0.5, bodies);
    TangentPath path;
    return path.plan(scene, bodies);
  };
  CHECK(gate(0.12) == TangentPath::Outcome::kFound);
  CHECK(gate(0.108) == TangentPath::Outcome::kTight);
  CHECK(gate(0.085) == TangentPath::Outcome::kTight);
  CHECK(gate(0.075) == TangentPath::Outcome::kNone);
  TangentGraphNavigator navigator({});
  const Guidance guidance = navigator.plan(setup.scene);
  CHECK(guidance.speed_cap == 0.0);
}

TEST_CASE("the side of an obstacle is kept while it moves a little across the line", "[unit]") {
  Setup setup;
  TangentGraphNavigator navigator({});
  const auto side = [&](double y) {
    setup.obstacles = {{{0.0, y}, 0.0335, {}}};
    const Guidance guidance = navigator.plan(setup.at({-0.5, 0.0}, {0.5, 0.0}));
    return guidance.path[guidance.path.size() / 2].y > y ? 1 : -1;
  };
  CHECK(side(-0.01) == 1);
  CHECK(side(0.005) == 1);
  CHECK(side(0.05) == -1);
  CHECK(side(0.005) == -1);
}

TEST_CASE("the path is planned again only when something has changed", "[unit]") {
  Setup setup;
  setup.obstacles = {{{0.0, 0.01}, 0.0335, {}}};
  TangentGraphNavigator navigator({});
  const auto first = navigator.plan(setup.at({-0.5, 0.0}, {0.5, 0.0})).revision;
  CHECK(navigator.plan(setup.at({-0.48, 0.0}, {0.5, 0.0})).revision == first);
  setup.obstacles[0].position.x += 0.01;
  CHECK(navigator.plan(setup.at({-0.48, 0.0}, {0.5, 0.0})).revision != first);
}

TEST_CASE("a wanted arrival heading is met from all sides", "[unit]") {
  for (const char* name : {"tangent-graph", "bezier", "hermite"}) {
    auto pilot = makePilot(*parseNavigator(name));
    REQUIRE(pilot);
    for (int i = 0; i < 8; ++i) {
      NavigationGoal goal;
      goal.position = {0.3, 0.1};
      goal.heading = math::wrapAngle(i * math::kPi / 4);
      const std::vector<DiscObstacle> obstacles{{{0.0, 0.05}, 0.0335, {}}};
      const auto result =
          test::kinematicTrial(**pilot, test::paperRobot(1.0), {}, {{-0.5, 0.0}, 0.0}, goal, obstacles, 6.0);
      INFO(name << " heading " << *goal.heading);
      CHECK(result.reached);
      CHECK_FALSE(result.touched);
    }
  }
}

TEST_CASE("the path methods are safe on the corner layouts at full speed", "[unit]") {
  FieldGeometry field;
  field.corner = 0.0;
  for (const char* name : {"tangent-graph", "bezier", "hermite"}) {
    auto pilot = makePilot(*parseNavigator(name));
    REQUIRE(pilot);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const test::CornerLayout layout = test::cornerLayout(seed);
      const auto result = test::kinematicTrial(**pilot, test::paperRobot(2.6), field, layout.start,
                                               layout.goal, layout.obstacles);
      INFO(name << " layout " << seed);
      CHECK(result.reached);
      CHECK_FALSE(result.touched);
    }
  }
}

}  // namespace fulbito
