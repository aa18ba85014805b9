#include "experiments/comparison/paper_figures.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/comparison/paper_plan.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// A trace at the origin with these headings [degrees].
std::vector<TraceRow> turning(const std::vector<double>& degrees) {
  std::vector<TraceRow> trace(degrees.size());
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    trace[i].robot.pose.heading = math::wrapAngle(degrees[i] * math::kPi / 180.0);
  }
  return trace;
}

std::vector<long> turns(const std::vector<double>& degrees, double least) {
  std::vector<long> whole;
  for (const HeadingTurn& turn : turnsOf(turning(degrees), least * math::kPi / 180.0)) {
    whole.push_back(std::lround(turn.angle * 180.0 / math::kPi));
  }
  return whole;
}

/// A run that drives `step` metres per row with these headings [degrees].
TrialRecord driving(const std::vector<double>& degrees, double step) {
  TrialRecord run;
  run.trace = turning(degrees);
  for (std::size_t i = 0; i < run.trace.size(); ++i) {
    run.trace[i].time = 0.1 * static_cast<double>(i);
    run.trace[i].robot.pose.position.x = step * static_cast<double>(i);
  }
  return run;
}

FigureCase ruled(FigureRule rule) {
  FigureCase figure;
  figure.rule = rule;
  figure.times = 2;
  figure.turn = 25.0 * math::kPi / 180.0;
  figure.within = 0.05;
  figure.near = 0.30;
  return figure;
}

Layout straightAhead() {
  Layout layout;
  layout.start = {{0.0, 0.0}, 0.0};
  layout.goal = {1.0, 0.0};
  return layout;
}

}  // namespace

TEST_CASE("turns go one way and the other, and wobbling is none", "[unit]") {
  CHECK(turns({0, 5, 0, -5, 0}, 20).empty());
  CHECK(turns({0, 30, 60, 55, 90}, 20) == std::vector<long>{90});
  CHECK(turns({0, 30, 60, 20, -10, 40}, 20) == std::vector<long>{60, -70, 50});
  CHECK(turns({0, -30, 0}, 20) == std::vector<long>{-30, 30});
  CHECK(turns({170, -170, -150}, 20) == std::vector<long>{40});  // across the discontinuity at 180 degrees
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

TEST_CASE("a turn is as abrupt as its steepest stretch of way", "[unit]") {
  const auto run = driving({0, 10, 20, 30, 30, 0, -30}, 0.02);
  const auto turns = turnsOf(run.trace, 0.3, 0.05);
  REQUIRE(turns.size() == 2);
  CHECK(turns[0].angle * 180.0 / math::kPi == Approx(30.0));
  CHECK(turns[0].abrupt * 180.0 / math::kPi == Approx(20.0));  // two steps of 2 cm
  CHECK(turns[1].abrupt * 180.0 / math::kPi == Approx(60.0));
}

TEST_CASE("abrupt turns count until a touch, and gentle ones never", "[unit]") {
  const FigureCase figure = ruled(FigureRule::kTurns);
  const Layout layout = straightAhead();
  auto run = driving({0, 30, 0, 40, 40}, 0.03);
  CHECK(judgeRun(figure, layout, run).shown);
  CHECK_FALSE(judgeRun(figure, layout, driving({0, 30, 0, 40, 40}, 0.06)).shown);
  run.touches.push_back({0.15, {}});
  const FigureVerdict bumped = judgeRun(figure, layout, run);
  CHECK_FALSE(bumped.shown);
  CHECK(bumped.measured == "makes one such turn (30 degrees); touches something once");
}

TEST_CASE("turning back is clockwise first, near the start", "[unit]") {
  const FigureCase figure = ruled(FigureRule::kTurnsBack);
  const Layout layout = straightAhead();
  CHECK(judgeRun(figure, layout, driving({90, 40, 80}, 0.01)).shown);
  CHECK_FALSE(judgeRun(figure, layout, driving({-90, -40, -80}, 0.01)).shown);
  CHECK_FALSE(judgeRun(figure, layout, driving({90, 40, 80}, 0.20)).shown);
  CHECK(judgeRun(figure, layout, driving({90, 40, 40}, 0.01)).measured == "turns 50 degrees clockwise");
}

TEST_CASE("driving away is way that is driven while the ball is behind", "[unit]") {
  FigureCase figure = ruled(FigureRule::kDrivesAway);
  figure.off = 0.05;
  // Two steps of 3 cm with the goal behind, no step, and one step with the goal behind at the end.
  CHECK(judgeRun(figure, straightAhead(), driving({180, 120, 80, 0}, 0.03)).shown);
  CHECK_FALSE(judgeRun(figure, straightAhead(), driving({180, 80, 80, 0}, 0.03)).shown);
}

TEST_CASE("what a run touches decides the rules on touches, and arriving the rule on failing", "[unit]") {
  const Layout layout = straightAhead();
  TrialRecord run = driving({0, 0}, 0.1);
  const auto shows = [&](FigureRule rule) { return judgeRun(ruled(rule), layout, run).shown; };
  CHECK(shows(FigureRule::kFails));
  run.score.arrived = true;
  CHECK_FALSE(shows(FigureRule::kFails));
  run.score.wall_contacts = 1;
  CHECK(shows(FigureRule::kTouchesWall));
  CHECK_FALSE(shows(FigureRule::kTouchesObstacle));
  run.score.obstacle_contacts = 2;
  CHECK(shows(FigureRule::kTouchesObstacle));
}

TEST_CASE("a figure is shown if all judged runs show it; runs beside it have no say", "[unit]") {
  const FigureRun judged{"a", true}, beside{"b", false};
  FigureRow row;
  row.runs = {{&judged, {true, ""}}, {&judged, {true, ""}}, {&beside, {false, ""}}};
  CHECK(verdictOf(row) == "yes");
  row.runs[1].verdict.shown = false;
  CHECK(verdictOf(row) == "partly");
  row.runs[0].verdict.shown = false, row.runs[2].verdict.shown = true;
  CHECK(verdictOf(row) == "no");
}

namespace {

/// The result of one trial of `specification` on `layout` with the standard physics.
TrialResult trialOf(const Layout& layout, const std::string& specification, double speed) {
  TrialConfig config;
  config.layout = layout;
  config.field = *loadField(layout.field);
  config.robot = *loadRobot("jung-lee-2015");
  config.robot.robot.max_wheel_speed = speed / config.robot.robot.wheel_radius;
  config.physics = *loadPhysics("standard");
  config.navigator = *parseNavigator(specification);
  auto result = runTrial(config, {});
  REQUIRE(result);
  return std::move(*result);
}

}  // namespace

TEST_CASE("a goal whose disc lies in the ring keeps the field away for ever, from every side, and no other",
          "[unit]") {
  // Two rings: one about a ball smaller than the ring, and one as large as the paper's. The robots are slow,
  // since a fast robot may coast in.
  for (const double ring : {0.10, 0.13}) {
    const std::string field = fmt::format("vector-field:offset={},width=0.04", ring);
    for (const double tolerance : {0.012, 0.02}) {
      for (const double share : {0.15, 0.6, 1.0}) {
        const double least = 0.078, most = ring - tolerance;
        for (const double side : {-2.6, -1.1, 0.4, 1.9}) {
          Layout layout;
          layout.obstacles.emplace_back();
          layout.obstacles[0].pose.position = {0.05, -0.03};
          layout.obstacles[0].radius = 0.0335;
          const Vec2 out = math::unit(side);
          layout.goal = layout.obstacles[0].pose.position + out * (least + share * (most - least));
          layout.goal_tolerance = tolerance;
          layout.start.position = layout.goal + math::unit(side + 0.5) * 0.24;
          layout.start.heading = math::angleOf(layout.goal - layout.start.position);
          CAPTURE(ring, tolerance, share, side);
          CHECK_FALSE(trialOf(layout, field, 0.2).score.arrived);
          CHECK_FALSE(trialOf(layout, field + ",follower=classic", 0.2).score.arrived);
          CHECK(trialOf(layout, "bezier", 0.2).score.arrived);
        }
      }
    }
  }
}

TEST_CASE("every named case of the paper has its figure, and every figure a case and a method", "[unit]") {
  CHECK(paperFigures().size() == namedCases().size());
  const std::vector<std::string> methods = figureMethods();
  for (const Layout& layout : namedCases()) {
    CAPTURE(layout.name);
    const FigureCase* figure = figureOf(layout.name);
    REQUIRE(figure != nullptr);
    int judged = 0;
    for (const FigureRun& run : figure->runs) {
      judged += run.judged ? 1 : 0;
      CHECK(std::find(methods.begin(), methods.end(), run.navigator) != methods.end());
    }
    CHECK(judged == 2);  // under both followers
  }
  CHECK(figureOf("corner-0") == nullptr);
}

namespace {

Comparison ran(const std::string& suite, std::vector<double> speeds = {}) {
  ComparisonConfig config;
  config.suite = suite;
  config.navigators = figureMethods();
  config.speeds = std::move(speeds);
  auto comparison = planComparison(config);
  REQUIRE(comparison);
  REQUIRE(runComparison(*comparison, {}, {}));
  return std::move(*comparison);
}

/// The last cell of the line of a page that starts with `first`.
std::string lastCell(const std::string& page, const std::string& first) {
  std::ifstream file(std::string(FULBITO_SOURCE_DIR) + "/" + page);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(first)) continue;
    const std::size_t end = line.rfind(" |"), begin = line.rfind("| ", end - 1) + 2;
    return line.substr(begin, end - begin);
  }
  return "no such line";
}

}  // namespace

TEST_CASE("the cases are judged by what their runs do, and the page says the same", "[unit]") {
  const Comparison comparison = ran("cases");
  const std::vector<FigureRow> rows = judgeFigures(comparison);
  REQUIRE(rows.size() == 9);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(rows[i].figure->layout.name);
    CHECK(rows[i].figure == &paperFigures()[i]);
    CHECK(rows[i].runs.size() == rows[i].figure->runs.size());
    for (const JudgedRun& run : rows[i].runs) CHECK_FALSE(run.verdict.measured.empty());
    const std::string name = rows[i].figure->title.substr(0, rows[i].figure->title.find(':'));
    CHECK(lastCell("docs/reproduction.md", "| " + name + " |") == verdictOf(rows[i]));
  }
  CHECK(markdownReport(comparison).find("### The paper's figures") != std::string::npos);
  const auto json = nlohmann::json::parse(resultsJson(comparison, 0.0));
  CHECK(json["figures"].size() == 9);
  CHECK(json["figures"][3]["runs"][0]["navigator"] == rows[3].runs[0].run->navigator);
  CHECK(json["figures"][3]["shown"] == verdictOf(rows[3]));
}

TEST_CASE("sweeps are judged place by place, by the runs of their figures", "[unit]") {
  ComparisonConfig config;
  config.suite = "sweeps";
  config.speeds = {0.7};
  auto planned = planComparison(config);
  REQUIRE(planned);
  CHECK(planned->blocks.front().navigators.size() == figureMethods().size());
  const Comparison comparison = ran("sweeps", {0.7});
  const std::vector<FigureRow> rows = judgeSweeps(comparison);
  CHECK(static_cast<int>(rows.size()) == sweepPlaces());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].figure == rows[i - 1].figure) CHECK(rows[i].value > rows[i - 1].value);
  }
  const std::string report = markdownReport(comparison);
  for (const FigureCase& figure : paperFigures()) {
    const bool named = report.find("### " + figure.title + ": which runs show it?") != std::string::npos;
    CHECK(named == (figure.sweep.steps > 0));
  }
  const auto json = nlohmann::json::parse(resultsJson(comparison, 0.0));
  CHECK(json["sweeps"].size() == rows.size());
}

}  // namespace fulbito
