#include "experiments/comparison/paper_figures.hpp"

#include <algorithm>

#include "experiments/comparison/paper_plan.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// A trace through these headings [degrees] at the origin.
std::vector<TraceRow> turning(const std::vector<double>& degrees) {
  std::vector<TraceRow> trace(degrees.size());
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    trace[i].robot.pose.heading = math::wrapAngle(degrees[i] * math::kPi / 180.0);
  }
  return trace;
}

std::vector<long> turns(const std::vector<double>& degrees, double least) {
  std::vector<long> whole;
  for (double turn : turnsOf(turning(degrees), least * math::kPi / 180.0)) {
    whole.push_back(std::lround(turn * 180.0 / math::kPi));
  }
  return whole;
}

}  // namespace

TEST_CASE("turns go one way and the other, and wobbling is none", "[unit]") {
  CHECK(turns({0, 5, 0, -5, 0}, 20).empty());
  CHECK(turns({0, 30, 60, 55, 90}, 20) == std::vector<long>{90});
  CHECK(turns({0, 30, 60, 20, -10, 40}, 20) == std::vector<long>{60, -70, 50});
  CHECK(turns({0, -30, 0}, 20) == std::vector<long>{-30, 30});
  CHECK(turns({170, -170, -150}, 20) == std::vector<long>{40});  // over the cut at 180 degrees
  CHECK(turns({}, 20).empty());
}

TEST_CASE("a detour is measured from the straight way, where it is asked for", "[unit]") {
  Layout layout;
  layout.start = {{0.0, 0.0}, 0.0};
  layout.goal = {1.0, 0.0};
  std::vector<TraceRow> trace(4);
  trace[1].robot.pose.position = {0.3, -0.20};
  trace[2].robot.pose.position = {0.6, 0.05};
  trace[3].robot.pose.position = {1.0, 0.0};
  CHECK(detourOf(layout, trace, -1e9, 1e9, false) == Approx(0.20));
  CHECK(detourOf(layout, trace, 0.5, 1e9, false) == Approx(0.05));
  CHECK(detourOf(layout, trace, -1e9, 1e9, true) == Approx(0.05));
}

TEST_CASE("every named case of the paper has its figure, and every figure a case and a method", "[unit]") {
  CHECK(paperFigures().size() == namedCases().size());
  const std::vector<std::string> methods = figureMethods();
  for (const Layout& layout : namedCases()) {
    CAPTURE(layout.name);
    const FigureClaim* figure = figureOf(layout.name);
    REQUIRE(figure != nullptr);
    CHECK(std::find(methods.begin(), methods.end(), figure->method) != methods.end());
    for (const std::string& other : figure->others) {
      CHECK(std::find(methods.begin(), methods.end(), other) != methods.end());
    }
  }
  CHECK(figureOf("corner-0") == nullptr);
}

TEST_CASE("the cases are judged by what their runs do", "[unit]") {
  ComparisonConfig config;
  config.suite = "cases";
  config.navigators = figureMethods();
  auto comparison = planComparison(config);
  REQUIRE(comparison);
  REQUIRE(runComparison(*comparison, {}, {}));
  const std::vector<FigureRow> rows = judgeFigures(*comparison);
  REQUIRE(rows.size() == 9);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(rows[i].figure->layout);
    CHECK(rows[i].figure == &paperFigures()[i]);
    CHECK_FALSE(rows[i].verdict.measured.empty());
  }
  // A touch is what the trials of figures 7 and 8 say, not a matter of the verdict.
  for (const FigureRow& row : rows) {
    if (row.figure->layout != "fig7-close-obstacle" && row.figure->layout != "fig8-close-obstacles") continue;
    const std::size_t index = row.figure->layout == "fig7-close-obstacle" ? 7 : 8;
    for (std::size_t n = 0; n < config.navigators.size(); ++n) {
      if (config.navigators[n] != row.figure->method) continue;
      CHECK(row.verdict.shown == !recordsOf(*comparison, 0, n)[index].touches.empty());
    }
  }
  CHECK(markdownReport(*comparison).find("### The paper's figures") != std::string::npos);
}

}  // namespace fulbito
