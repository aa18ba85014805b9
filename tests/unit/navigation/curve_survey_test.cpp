#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "engine/core/math.hpp"
#include "engine/core/random.hpp"
#include "navigation/registry.hpp"
#include "navigation/tangent_graph_search.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito {
namespace {

constexpr int kLayouts = 200;

FieldGeometry comparisonField() {
  FieldGeometry field;
  field.corner = 0.0;
  return field;
}

double shortestLength(const test::CornerLayout& layout, const FieldGeometry& field) {
  std::vector<Circle> circles;
  for (const DiscObstacle& o : layout.obstacles) circles.push_back({o.position, o.radius + 0.058});
  TangentGraph graph;
  graph.search(layout.start.position, layout.goal.position, circles, &field, 0.053);
  return graph.length();
}

struct Row {
  int reached = 0, safe = 0;
  double ratio = 0.0, time = 0.0, clearance = 0.0;
};

/// @param heading  wanted on arrival; NaN: start and arrival headings at random
Row survey(const std::string& specification, double speed, std::optional<double> heading) {
  const FieldGeometry field = comparisonField();
  const RobotModel robot = test::paperRobot(speed);
  auto pilot = makePilot(*parseNavigator(specification));
  REQUIRE(pilot);
  Row row;
  for (int seed = 0; seed < kLayouts; ++seed) {
    test::CornerLayout layout = test::cornerLayout(static_cast<std::uint64_t>(seed));
    layout.goal.heading = heading;
    if (heading && std::isnan(*heading)) {
      Rng rng(static_cast<std::uint64_t>(seed), Stream::kTest, 3);
      layout.start.heading = rng.uniform(-math::kPi, math::kPi);
      layout.goal.heading = rng.uniform(-math::kPi, math::kPi);
    }
    const auto result =
        test::kinematicTrial(**pilot, robot, field, layout.start, layout.goal, layout.obstacles);
    if (result.reached) ++row.reached;
    if (!result.reached || result.touched) continue;
    ++row.safe;
    row.ratio += result.length / shortestLength(layout, field);
    row.time += result.time;
    row.clearance += result.min_clearance;
  }
  return row;
}

void print(const std::string& name, double speed, const Row& row) {
  const double n = std::max(1, row.safe);
  fmt::print(
      "{:34} {:3.1f} m/s: reached {:5.1f} % safe {:5.1f} %  L/L* {:.3f}  T {:.3f} s  clearance {:.1f} cm\n",
      name, speed, 100.0 * row.reached / kLayouts, 100.0 * row.safe / kLayouts, row.ratio / n, row.time / n,
      100.0 * row.clearance / n);
}

}  // namespace

TEST_CASE("survey of the path methods on the corner layouts", "[.][survey]") {
  for (const char* name : {"tangent-graph", "bezier", "bezier:all_sides=true", "hermite", "bezier-raw"}) {
    for (double speed : {0.6, 1.0, 2.6}) print(name, speed, survey(name, speed, {}));
  }
  for (const char* name : {"tangent-graph", "bezier", "hermite"}) {
    for (double heading : {0.7, -0.8, 2.2, -2.4, std::nan("")}) {
      print(fmt::format("{}, arrival {:.1f} rad", name, heading), 1.0, survey(name, 1.0, heading));
      print(fmt::format("{}, arrival {:.1f} rad", name, heading), 2.6, survey(name, 2.6, heading));
    }
  }
}

TEST_CASE("survey of the path methods among crossing obstacles", "[.][survey]") {
  const FieldGeometry field = comparisonField();
  for (const char* name : {"tangent-graph", "bezier", "bezier:yield=0", "hermite", "bezier-raw"}) {
    auto pilot = makePilot(*parseNavigator(name));
    for (double speed : {1.0, 2.6}) {
      int safe = 0, reached = 0;
      for (int seed = 0; seed < kLayouts; ++seed) {
        Rng rng(static_cast<std::uint64_t>(seed), Stream::kTest, 9);
        std::vector<DiscObstacle> obstacles;
        const int count = 1 + static_cast<int>(rng.below(5));
        for (int i = 0; i < count; ++i) {
          const double side = rng.below(2) == 0 ? 1.0 : -1.0;
          obstacles.push_back({{rng.uniform(-0.4, 0.5), side * rng.uniform(0.3, 0.6)},
                               0.0375,
                               {rng.uniform(-0.2, 0.2), -side * rng.uniform(0.3, 1.0)}});
        }
        NavigationGoal goal;
        goal.position = {0.63, 0.0};
        const auto result = test::kinematicTrial(**pilot, test::paperRobot(speed), field, {{-0.63, 0.0}, 0.0},
                                                 goal, obstacles);
        if (result.reached) ++reached;
        if (result.reached && !result.touched) ++safe;
      }
      fmt::print("{:24} {:3.1f} m/s, crossing: reached {:5.1f} % safe {:5.1f} %\n", name, speed,
                 100.0 * reached / kLayouts, 100.0 * safe / kLayouts);
    }
  }
}

TEST_CASE("survey of the path methods' planning time", "[.][survey]") {
  const FieldGeometry field = comparisonField();
  const RobotModel robot = test::paperRobot(1.0);
  for (const char* name : {"tangent-graph", "bezier", "bezier:all_sides=true", "hermite", "bezier-raw"}) {
    for (std::size_t count : {4U, 9U, 20U}) {
      const auto choice = parseNavigator(name);
      auto navigator = choice->info->make(choice->settings);
      Rng rng(count, Stream::kTest, 5);
      std::vector<double> times;
      for (int i = 0; i < 2000; ++i) {
        std::vector<DiscObstacle> obstacles;
        NavigationScene scene;
        scene.field = &field;
        scene.robot = &robot;
        scene.self.pose.position = {rng.uniform(-0.68, 0.68), rng.uniform(-0.58, 0.58)};
        scene.goal.position = {rng.uniform(-0.68, 0.68), rng.uniform(-0.58, 0.58)};
        while (obstacles.size() < count) {
          const DiscObstacle o{{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, 0.0375, {}};
          const double room = std::min(distance(o.position, scene.self.pose.position),
                                       distance(o.position, scene.goal.position));
          if (room > 0.08) obstacles.push_back(o);
        }
        scene.obstacles = obstacles;
        (*navigator)->reset();
        const auto from = std::chrono::steady_clock::now();
        (*navigator)->plan(scene);
        times.push_back(
            std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count());
      }
      std::sort(times.begin(), times.end());
      fmt::print("{:24} {:2} obstacles: p50 {:6.1f} p99 {:7.1f} max {:7.1f} us\n", name, count,
                 times[times.size() / 2], times[times.size() * 99 / 100], times.back());
    }
  }
}

}  // namespace fulbito
