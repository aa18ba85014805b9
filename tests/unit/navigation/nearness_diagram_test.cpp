#include "navigation/nearness_diagram.hpp"

#include <cstdlib>

#include "tests/support/catch.hpp"
#include "tests/support/corner_survey.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {

TEST_CASE("the nearness diagram keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("nearness-diagram");
}

TEST_CASE("survey of the nearness diagram on corner layouts", "[.][survey]") {
  const char* extra = std::getenv("ND");
  const std::string spec = std::string("nearness-diagram") + (extra ? extra : "");
  test::printCornerSurvey(spec);
  std::printf("p99 %.1f us a tick\n", test::tickTime99(spec));
}

}  // namespace fulbito
