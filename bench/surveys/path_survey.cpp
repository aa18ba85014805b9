// Tables of the path methods.
#include "tests/support/catch.hpp"
#include "tests/support/suite_layouts.hpp"
#include "tests/support/survey.hpp"

namespace fulbito {
namespace {

constexpr const char* kMethods[] = {"tangent-graph", "bezier", "bezier:all_sides=true", "hermite",
                                    "bezier-raw"};

void print(const std::string& name, test::LayoutMaker layout) {
  test::SurveyTask task;
  task.layout = std::move(layout);
  task.field.corner = 0.0;
  test::printSurvey(name, name, std::move(task));
}

}  // namespace

TEST_CASE("survey of the path methods on the corner layouts", "[survey]") {
  for (const char* name : kMethods) print(name, test::cornerLayout);
}

TEST_CASE("survey of the path methods with arrival headings", "[survey]") {
  for (const char* name : {"tangent-graph", "bezier", "hermite"}) print(name, test::headingLayout);
}

TEST_CASE("survey of the path methods among crossing obstacles", "[survey]") {
  for (const char* name : {"tangent-graph", "bezier", "bezier:yield=0", "hermite", "bezier-raw"}) {
    print(name, test::crossingLayout);
  }
}

TEST_CASE("survey of the path methods' planning time", "[survey]") {
  for (const char* name : kMethods) {
    for (std::size_t obstacles : {4U, 9U, 20U}) test::printPlanningTime(name, obstacles);
  }
}

}  // namespace fulbito
