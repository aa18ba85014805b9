#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/models.hpp"
#include "trials/figure_case.hpp"
#include "trials/suite_layouts.hpp"

namespace fulbito {

namespace {

constexpr double kSquareClearance =
    0.0395;  // [m] half the robot's width + 2 mm, for gaps that are entered straight

Layout caseLayout(std::uint64_t, std::uint64_t index) { return namedCases()[index % namedCases().size()]; }

Layout sweepLayout(std::uint64_t, std::uint64_t index) {
  const SweepPlace place = sweepPlace(index);
  Layout layout = sweptLayout(*place.figure, place.value);
  const bool angle = place.figure->sweep.kind == SweepKind::kHeading;
  layout.name = angle ? fmt::format("{}-{:.0f}deg", layout.name, place.value)
                      : fmt::format("{}-{:.1f}mm", layout.name, 1000 * place.value);
  return layout;
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
  using enum ForbiddenContacts;
  const std::vector<double> both = {1.0, 2.6};
  static const std::vector<Suite> all = {
      {"corner",
       "corner to corner past four tennis balls",
       400,
       {0.6, 1.0, 2.6},
       kAll,
       0.058,
       false,
       cornerLayout},
      {"short", "0.55 to 0.75 m past the balls of corner", 200, both, kAll, 0.058, false, shortLayout},
      {"close-range",
       "the corner layout shrunk to 0.58 to 0.72 m",
       400,
       {0.6},
       kAll,
       0.058,
       false,
       closeRangeLayout},
      {"heading", "corner with any initial heading and an arrival heading", 200, both, kAll, 0.058, false,
       headingLayout},
      {"walls", "starts that touch walls and corners, goals near walls and obstacles", 100, both, kObstacles,
       0.055, false, wallsLayout},
      {"clutter", "robot-sized obstacles, gaps of 1.3 robot widths", 300, both, kAll, kSquareClearance, false,
       clutter13Layout},
      {"clutter-1.1", "clutter with gaps of 1.1 robot widths", 300, both, kAll, kSquareClearance, false,
       clutter11Layout},
      {"clutter-1.6", "clutter with gaps of 1.6 robot widths", 300, both, kAll, kSquareClearance, false,
       clutter16Layout},
      {"u-trap", "a U of obstacles between start and goal", 100, both, kAll, kSquareClearance, false,
       uTrapLayout},
      {"moving", "one to five obstacles crossing at 0.3 to 1.5 m/s, bouncing off the walls", 1000, both,
       kOwnMotion, 0.058, false, movingLayout},
      {"sonar",
       "gaps of 1.3 widths, clutter and rows, known by eight noisy sonars only",
       300,
       {0.3},
       kAll,
       kSquareClearance,
       false,
       sonar13Layout,
       true},
      {"sonar-1.1",
       "sonar with gaps of 1.1 robot widths",
       300,
       {0.3},
       kAll,
       kSquareClearance,
       false,
       sonar11Layout,
       true},
      {"sonar-1.6",
       "sonar with gaps of 1.6 robot widths",
       300,
       {0.3},
       kAll,
       kSquareClearance,
       false,
       sonar16Layout,
       true},
      {"cases",
       "named cases: the figures of Jung & Lee (2015)",
       static_cast<int>(namedCases().size()),
       {1.0},
       kAll,
       0.058,
       true,
       caseLayout},
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
