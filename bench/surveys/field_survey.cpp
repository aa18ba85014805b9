// Tables of the field methods with the kinematic robot.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {
namespace {

constexpr double kRoomAtEnds = 0.15;  // [m] between a ball's centre and start or goal of a short run

/// A corner layout scaled to `length` [m] from start to goal, with balls of unchanged size. Empty if balls
/// then overlap or are too near to start or goal.
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

/// Returns one after the other the layouts that can be shortened to `length` [m].
test::LayoutMaker shortRuns(double length) {
  return [length, seed = std::uint64_t{0}](std::uint64_t) mutable {
    for (;;) {
      if (const auto layout = shortened(test::cornerLayout(seed++), length)) return *layout;
    }
  };
}

void print(const test::Survey& s) {
  std::printf(" | %3.0f %3.0f %.3f %.3f", 100.0 * s.safe / s.runs, 100.0 * (s.runs - s.reached) / s.runs,
              s.over_straight, s.time);
}

}  // namespace

TEST_CASE("survey of the field methods corner to corner", "[survey]") {
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
      test::SurveyTask task;
      task.speed = speed;
      print(test::survey(specification, task));
    }
    std::printf("\n");
  }
}

TEST_CASE("survey of short runs with the wide ring", "[survey]") {
  for (double length : {0.58, 0.65, 0.72}) {
    for (const char* width : {"0.10", "0.15", "0.20"}) {
      const std::string specification =
          std::string("vector-field:offset=0.10,follower=classic,width=") + width;
      test::SurveyTask task;
      task.layout = shortRuns(length);
      task.speed = 0.6;
      std::printf("%-60s %.2f m", specification.c_str(), length);
      print(test::survey(specification, task));
      std::printf("\n");
    }
  }
}

}  // namespace fulbito
