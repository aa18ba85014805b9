#include "navigation/dwa.hpp"

#include "engine/core/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_survey.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {
namespace {

/// Mean over three speeds and 25 layouts of the time over a rough bound of it; a failure counts as 8.
double tuningCost(const std::string& specification) {
  constexpr int kLayouts = 25;
  double cost = 0.0;
  for (double speed : {0.6, 1.0, 2.6}) {
    const test::CornerSurvey s = test::surveyCorners(specification, speed, 9000, kLayouts);
    const double bound = 1.65 / speed + speed / 10.0;
    cost += (s.safe * s.time / bound + 8.0 * (kLayouts - s.safe)) / (3.0 * kLayouts);
  }
  return cost;
}

}  // namespace

TEST_CASE("the dynamic window approach keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("dwa");
}

TEST_CASE("survey of the dynamic window approach on corner layouts", "[.][survey]") {
  test::printCornerSurvey("dwa");
  std::printf("p99 of a tick %.1f us\n", test::tickTime99("dwa"));
}
TEST_CASE("weights of the dynamic window approach on layouts apart from the survey's", "[.][tune]") {
  for (const char* velocity : {"0.3", "0.5", "0.7"}) {
    for (const char* clearance : {"0.3", "0.4", "0.6"}) {
      for (const char* heading : {"0", "0.02", "0.1"}) {
        const std::string weights =
            std::string("velocity=") + velocity + ",clearance=" + clearance + ",heading=" + heading;
        std::printf("cost %.3f %s\n", tuningCost("dwa:" + weights), weights.c_str());
      }
    }
  }
}

}  // namespace fulbito
