#include "experiments/trials/figure_case.hpp"

#include <set>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

const std::string kLayout = R"([layout]
field = "vsss-3v3"
[start]
position = [-0.20, 0.30]
heading_deg = 90.0
[goal]
position = [0.10, 0.50]
[[obstacle]]
position = [-0.19, 0.45]
radius = 0.03
)";
const std::string kFigure = R"([figure]
title = "Fig. 0: a test"
paper = "something happens"
rule = "turns"
times = 3
turn_deg = 25.0
within = 0.04
)";
const std::string kRun = "[[run]]\nnavigator = \"bezier:clearance=0.03\"\njudged = true\n";

std::string messageOf(const std::string& text) {
  const auto figure = parseFigureCase(text, "f.toml");
  REQUIRE_FALSE(figure);
  CHECK(figure.error().code == ErrorCode::kBadInput);
  return figure.error().message;
}

FigureCase swept(const std::string& what) {
  const std::string sweep = "[sweep]\nwhat = \"" + what + "\"\nfrom = 0.01\nto = 0.05\nsteps = 5\n";
  auto figure = parseFigureCase(kLayout + kFigure + sweep + kRun, "f.toml");
  REQUIRE(figure);
  return std::move(*figure);
}

}  // namespace

TEST_CASE("a case file names its rule, its runs and its sweep", "[unit]") {
  const FigureCase figure = swept("obstacle-gap");
  CHECK(figure.layout.name == "f");
  CHECK(figure.rule == FigureRule::kTurns);
  CHECK(figure.times == 3);
  CHECK(figure.turn == Approx(25.0 * math::kPi / 180.0));
  CHECK(ruleText(figure) ==
        "turns by at least 25 degrees within 4.0 cm of way, at least 3 times, without a touch");
  REQUIRE(runOf(figure, "bezier:clearance=0.03") != nullptr);
  CHECK(runOf(figure, "bezier:clearance=0.03")->judged);
  CHECK(runOf(figure, "bezier") == nullptr);
  CHECK_FALSE(figure.window);
  CHECK(sweepValue(figure.sweep, 0) == 0.01);
  CHECK(sweepValue(figure.sweep, 3) == Approx(0.04));
  CHECK(sweepText(figure.sweep, 0.04) == "40.0 mm");
}

TEST_CASE("a wrong case file is refused with its line", "[unit]") {
  CHECK(messageOf(kLayout + kRun).find("figure") != std::string::npos);
  CHECK(messageOf(kLayout + "[figure]\ntitle = \"t\"\npaper = \"p\"\nrule = \"turn\"\n").find("f.toml:14:") ==
        0);
  CHECK(messageOf(kLayout + kFigure + "[[run]]\nnavigator = \"bezir\"\n").find("Did you mean 'bezier'?") !=
        std::string::npos);
  CHECK(messageOf(kLayout + kFigure + kRun + "speed = 1.0\n").find("speed") != std::string::npos);
}

TEST_CASE("a sweep changes the one quantity that it names", "[unit]") {
  const FigureCase gap = swept("obstacle-gap"), wall = swept("wall-gap"), ball = swept("ball-distance"),
                   heading = swept("heading");
  const Layout& whole = gap.layout;
  // Ahead is up. The body's front is 3.75 cm above the start, and the obstacle's lowest point 3 cm below its
  // centre.
  const Layout nearer = sweptLayout(gap, 0.02);
  CHECK(nearer.obstacles[0].pose.position.x == Approx(whole.obstacles[0].pose.position.x));
  CHECK(nearer.obstacles[0].pose.position.y == Approx(0.30 + 0.0375 + 0.02 + 0.03));
  CHECK(nearer.start.position == whole.start.position);
  const Layout at_wall = sweptLayout(wall, 0.02);
  CHECK(at_wall.start.position.x == whole.start.position.x);
  CHECK(at_wall.start.position.y == Approx(0.65 - 0.0375 - 0.02));
  const Layout at_ball = sweptLayout(ball, 0.09);
  CHECK(distance(at_ball.goal, whole.obstacles[0].pose.position) == Approx(0.09));
  CHECK(cross(at_ball.goal - whole.obstacles[0].pose.position,
              whole.goal - whole.obstacles[0].pose.position) == Approx(0.0).margin(1e-12));
  CHECK(sweptLayout(heading, -30.0).start.heading == Approx(-math::kPi / 6));
}

TEST_CASE("the suite of sweeps holds each figure's sweep from end to end", "[unit]") {
  const Suite& suite = **findSuite("sweeps");
  std::set<std::string> names;
  int steps = 0;
  for (const FigureCase& figure : paperFigures()) {
    for (int step = 0; step < figure.sweep.steps; ++step, ++steps) {
      const SweepPlace place = sweepPlace(static_cast<std::uint64_t>(steps));
      CHECK(place.figure == &figure);
      CHECK(place.value == sweepValue(figure.sweep, step));
      names.insert(suite.layout(1, static_cast<std::uint64_t>(steps)).name);
    }
  }
  CHECK(steps == suite.default_trials);
  CHECK(names.size() == static_cast<std::size_t>(steps));
}

}  // namespace fulbito
