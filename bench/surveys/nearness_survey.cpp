// Tables of the nearness diagram with different braking shares.
#include <cstdio>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {

TEST_CASE("survey of the nearness diagram on corner layouts", "[survey]") {
  test::printSurvey("nearness-diagram", "nearness-diagram", {});
  test::printPlanningTime("nearness-diagram", 9);
}

TEST_CASE("braking shares of the nearness diagram on layouts apart from the survey's", "[tune]") {
  for (const char* braking : {"0.15", "0.2", "0.25", "0.3", "0.4", "0.6"}) {
    for (double speed : {1.0, 2.6}) {
      test::SurveyTask task;
      task.speed = speed;
      task.first_seed = 5000;
      const test::Survey s = test::survey(std::string("nearness-diagram:braking=") + braking, task);
      std::printf("braking %s at %.1f m/s: safe %5.1f %%, T %.3f s\n", braking, speed, s.safe / 2.0, s.time);
    }
  }
}

}  // namespace fulbito
