#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "experiments/trials/figure_case.hpp"
#include "experiments/trials/suite_layouts.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

namespace {

constexpr double kSquareClearance = 0.0395;  // [m] half the robot's width + 2 mm

Layout caseLayout(std::uint64_t, std::uint64_t index) { return namedCases()[index % namedCases().size()]; }

Layout sweepLayout(std::uint64_t, std::uint64_t index) {
  const SweepPlace place = sweepPlace(index);
  Layout layout = sweptLayout(*place.figure, place.value);
  const bool angle = place.figure->sweep.kind == SweepKind::kHeading;
  layout.name = angle ? fmt::format("{}-{:.0f}deg", layout.name, place.value)
                      : fmt::format("{}-{:.1f}mm", layout.name, 1000 * place.value);
  return layout;
}

using DrawLayout = decltype(Suite::layout);

/// A suite in which the robot must touch nothing, with the default clearance.
Suite openSuite(std::string name, std::string summary, int trials, std::vector<double> speeds,
                DrawLayout layout) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .default_trials = trials,
          .speeds = std::move(speeds),
          .layout = layout};
}

/// A suite that allows contacts which cannot be avoided.
Suite touchingSuite(std::string name, std::string summary, int trials, ForbiddenContacts forbidden,
                    double clearance, DrawLayout layout) {
  Suite suite = openSuite(std::move(name), std::move(summary), trials, {1.0, 2.6}, layout);
  suite.forbidden = forbidden;
  suite.limit_clearance = clearance;
  return suite;
}

/// A suite with gaps between obstacles, which the robot must enter straight.
Suite gapSuite(std::string name, std::string summary, int trials, DrawLayout layout) {
  Suite suite = openSuite(std::move(name), std::move(summary), trials, {1.0, 2.6}, layout);
  suite.limit_clearance = kSquareClearance;
  return suite;
}

/// A suite with gaps that the robot knows only by its sonars.
Suite sonarSuite(std::string name, std::string summary, DrawLayout layout) {
  Suite suite = gapSuite(std::move(name), std::move(summary), 300, layout);
  suite.speeds = {0.3};
  suite.sonars_only = true;
  return suite;
}

}  // namespace

const std::vector<Layout>& namedCases() {
  static const std::vector<Layout> cases = [] {
    std::vector<Layout> layouts;
    for (const FigureCase& figure : paperFigures()) layouts.push_back(figure.layout);
    return layouts;
  }();
  return cases;
}

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      openSuite("corner", "corner to corner past four tennis balls", 400, {0.6, 1.0, 2.6}, cornerLayout),
      openSuite("short", "0.55 to 0.75 m past the balls of corner", 200, {1.0, 2.6}, shortLayout),
      openSuite("close-range", "the corner layout shrunk to 0.58 to 0.72 m", 400, {0.6}, closeRangeLayout),
      openSuite("heading", "corner with any initial heading and an arrival heading", 200, {1.0, 2.6},
                headingLayout),
      touchingSuite("walls", "starts that touch walls and corners, goals near walls and obstacles", 100,
                    ForbiddenContacts::kObstacles, 0.055, wallsLayout),
      gapSuite("clutter", "robot-sized obstacles, gaps of 1.3 robot widths", 300, clutter13Layout),
      gapSuite("clutter-1.1", "clutter with gaps of 1.1 robot widths", 300, clutter11Layout),
      gapSuite("clutter-1.6", "clutter with gaps of 1.6 robot widths", 300, clutter16Layout),
      gapSuite("u-trap", "a U of obstacles between start and goal", 100, uTrapLayout),
      touchingSuite("moving", "one to five obstacles crossing at 0.3 to 1.5 m/s, bouncing off the walls",
                    1000, ForbiddenContacts::kOwnMotion, 0.058, movingLayout),
      sonarSuite("sonar", "gaps of 1.3 widths, clutter and rows, known by eight noisy sonars only",
                 sonar13Layout),
      sonarSuite("sonar-1.1", "sonar with gaps of 1.1 robot widths", sonar11Layout),
      sonarSuite("sonar-1.6", "sonar with gaps of 1.6 robot widths", sonar16Layout),
      {.name = "cases",
       .summary = "named cases: the figures of Jung & Lee (2015)",
       .default_trials = static_cast<int>(namedCases().size()),
       .speeds = {1.0},
       .always_drawn = true,
       .layout = caseLayout},
      {.name = "sweeps",
       .summary = "figures of Jung & Lee (2015) over what their drawings leave open",
       .default_trials = sweepPlaces(),
       .speeds = {0.2, 1.0},
       .layout = sweepLayout,
       .always_traced = true},
  };
  return all;
}

Result<const Suite*> findSuite(const std::string& name) {
  std::vector<std::string> names;
  for (const Suite& suite : suites()) {
    if (suite.name == name) return &suite;
    names.push_back(suite.name);
  }
  names.emplace_back("jung-lee-2015");
  return fail(ErrorCode::kUsage, fmt::format("there is no suite '{}'.{}", name, suggestion(name, names)));
}

}  // namespace fulbito
