#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "navigation/registry.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

// Not a test but a table: `navigation_test [survey]` prints how the field methods fare with the kinematic
// robot.
namespace fulbito {
namespace {

constexpr int kLayouts = 200;
constexpr double kRoomAtEnds = 0.15;  // [m] between a ball's centre and the ends of a short run

struct Row {
  int runs = 0;
  int safe = 0;
  int hung = 0;
  double length = 0.0;  ///< over the straight line, mean of safe runs
  double time = 0.0;    ///< [s] mean of safe runs
};

/// A run of `length` [m] with the corner layout's places drawn together to it, the balls' size kept; none
/// where the balls then overlap or leave no room at the ends.
std::optional<test::CornerLayout> shortened(test::CornerLayout layout, double length) {
  const double scale = length / distance(layout.start.position, layout.goal.position);
  layout.start.position *= scale;
  layout.goal.position *= scale;
  for (DiscObstacle& o : layout.obstacles) o.position *= scale;
  for (const DiscObstacle& o : layout.obstacles) {
    if (distance(o.position, layout.start.position) < kRoomAtEnds) return {};
    if (distance(o.position, layout.goal.position) < kRoomAtEnds) return {};
    for (const DiscObstacle& other : layout.obstacles) {
      if (&o != &other && distance(o.position, other.position) < 2 * o.radius) return {};
    }
  }
  return layout;
}

Row survey(const std::string& specification, double speed, double run_length) {
  const auto choice = parseNavigator(specification);
  REQUIRE(choice);
  auto pilot = makePilot(*choice);
  REQUIRE(pilot);
  Row row;
  for (std::uint64_t seed = 0; row.runs < kLayouts; ++seed) {
    test::CornerLayout layout = test::cornerLayout(seed);
    if (run_length > 0.0) {
      const auto shorter = shortened(layout, run_length);
      if (!shorter) continue;
      layout = *shorter;
    }
    ++row.runs;
    const auto result = test::kinematicTrial(**pilot, test::paperRobot(speed), {}, layout.start, layout.goal,
                                             layout.obstacles);
    if (!result.reached) ++row.hung;
    if (!result.reached || result.touched) continue;
    ++row.safe;
    row.length += result.length / distance(layout.start.position, layout.goal.position);
    row.time += result.time;
  }
  row.length /= std::max(row.safe, 1);
  row.time /= std::max(row.safe, 1);
  return row;
}

}  // namespace

TEST_CASE("survey of the field methods corner to corner", "[.][survey]") {
  const std::vector<std::string> specifications = {
      "vector-field",
      "vector-field:offset=0.10,width=0.20,follower=classic",
      "univector",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.046",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10,follower=classic",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.20,follower=classic",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10,hold_side=on",
      "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10,shrink=on,ignore_beyond=on",
      "tangent-field",
      "tangent-field:hysteresis=0",
      "tangent-field:offset=0.11",
      "tangent-field:offset=0.085,range=1.16",
      "limit-cycle",
      "limit-cycle:hysteresis=0",
      "limit-cycle:margin=0.0235,mu=3",
      "limit-cycle:margin=0.0435,mu=1",
  };
  std::printf("%-80s %s\n", "specification",
              "| 0.6, 1.0, 2.6 m/s: safe %, hung %, length/straight, time [s]");
  for (const std::string& specification : specifications) {
    std::printf("%-80s", specification.c_str());
    for (double speed : {0.6, 1.0, 2.6}) {
      const Row row = survey(specification, speed, 0.0);
      std::printf(" | %3.0f %3.0f %.3f %.3f", 100.0 * row.safe / kLayouts, 100.0 * row.hung / kLayouts,
                  row.length, row.time);
    }
    std::printf("\n");
  }
}

TEST_CASE("survey of short runs with the wide ring", "[.][survey]") {
  for (double length : {0.58, 0.65, 0.72}) {
    for (const char* width : {"0.10", "0.15", "0.20"}) {
      const std::string specification =
          std::string("vector-field:offset=0.10,follower=classic,width=") + width;
      const Row row = survey(specification, 0.6, length);
      std::printf("%-60s %.2f m | %3.0f %3.0f %.3f %.3f\n", specification.c_str(), length,
                  100.0 * row.safe / kLayouts, 100.0 * row.hung / kLayouts, row.length, row.time);
    }
  }
}

}  // namespace fulbito
