// Tables of the dynamic window approach with different weights.
#include <cstdio>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {
namespace {

/// Mean cost over three speeds and 25 layouts. A run costs its time over a rough lower bound plus its length
/// over the straight distance; a failed run costs 8.
double tuningCost(const std::string& specification) {
  constexpr int kLayouts = 25;
  double cost = 0.0;
  for (double speed : {0.6, 1.0, 2.6}) {
    test::SurveyTask task;
    task.speed = speed;
    task.first_seed = 9000;
    task.runs = kLayouts;
    const test::Survey s = test::survey(specification, task);
    const double bound = 1.65 / speed + speed / 10.0;
    cost += (s.safe * (s.time / bound + s.over_straight) + 8.0 * (kLayouts - s.safe)) / (3.0 * kLayouts);
  }
  return cost;
}

}  // namespace

TEST_CASE("survey of the dynamic window approach on corner layouts", "[survey]") {
  test::printSurvey("dwa", "dwa", {});
  test::printPlanningTime("dwa", 9);
}

TEST_CASE("weights of the dynamic window approach on layouts apart from the survey's", "[tune]") {
  for (const char* preview : {"0.25", "0.3", "0.4"}) {
    for (const char* velocity : {"0.3", "0.5", "0.7"}) {
      for (const char* clearance : {"0.4", "0.6", "0.8"}) {
        for (const char* heading : {"0", "0.1"}) {
          const std::string weights = std::string("preview=") + preview + ",velocity=" + velocity +
                                      ",clearance=" + clearance + ",heading=" + heading;
          std::printf("cost %.3f %s\n", tuningCost("dwa:" + weights), weights.c_str());
        }
      }
    }
  }
}

}  // namespace fulbito
