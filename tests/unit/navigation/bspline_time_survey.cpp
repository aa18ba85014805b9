// Hidden surveys of the default navigator: `navigation_test "[survey]"` prints the tables.
#include <algorithm>
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "navigation/registry.hpp"
#include "navigation/tangent_graph_search.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito {
namespace {

struct Tally {
  int runs = 0, reached = 0, safe = 0;
  double length = 0, time = 0, clearance = 0, worst_time = 0;
};

std::string specification() {
  const char* s = std::getenv("NAV");
  return s ? s : kDefaultNavigator;
}
int count(int fallback) {
  const char* s = std::getenv("COUNT");
  return s ? std::atoi(s) : fallback;
}

double shortest(Vec2 start, Vec2 goal, const std::vector<DiscObstacle>& obstacles, double clearance) {
  std::vector<Circle> circles;
  for (const auto& o : obstacles) circles.push_back({o.position, o.radius + clearance});
  TangentGraph graph;
  return graph.search(start, goal, circles) ? graph.length() : distance(start, goal);
}

void print(const char* name, double speed, const Tally& t) {
  const double n = std::max(1, t.safe);
  fmt::print(
      "{:10} {:4.1f}  reached {:5.1f} %  safe {:5.1f} %  L/L* {:.4f}  T/T* {:.4f} (worst {:.3f})  clear "
      "{:.4f}\n",
      name, speed, 100.0 * t.reached / t.runs, 100.0 * t.safe / t.runs, t.length / n, t.time / n,
      t.worst_time, t.clearance / n);
}

void add(Tally& t, const test::KinematicResult& r, double best, double speed, int seed) {
  ++t.runs;
  if (r.reached) ++t.reached;
  const double bound = best >= speed * speed / 10 ? best / speed + speed / 10.0 : std::sqrt(2 * best / 5);
  if (r.reached && !r.touched) {
    ++t.safe;
    t.length += r.length / best;
    t.time += r.time / bound;
    t.worst_time = std::max(t.worst_time, r.time / bound);
    t.clearance += r.min_clearance;
  } else if (std::getenv("VERBOSE")) {
    fmt::print("  seed {} reached {} clearance {:.4f} time {:.2f} end {:.3f} {:.3f} heading {:.2f}\n", seed,
               r.reached, r.min_clearance, r.time, r.path.back().x, r.path.back().y, r.final_heading);
  }
}

}  // namespace

TEST_CASE("survey N1", "[.][survey]") {
  auto pilot = makePilot(*parseNavigator(specification()));
  REQUIRE(pilot);
  for (double speed : {0.6, 1.0, 2.6}) {
    Tally t;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(200); ++seed) {
      const auto layout = test::cornerLayout(seed);
      const auto r = test::kinematicTrial(**pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.058), speed, seed);
    }
    print("N1", speed, t);
  }
}

}  // namespace fulbito
