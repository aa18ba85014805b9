#include <set>

#include "engine/core/models/shapes.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "trials/suite_layouts.hpp"

namespace fulbito {

TEST_CASE("every suite's layouts are possible: nothing overlaps and all is on the field", "[unit]") {
  RobotModel robot;
  for (const Suite& suite : suites()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Layout layout = suite.layout(7, i);
      INFO(layout.name);
      const auto field = loadField(layout.field);
      REQUIRE(field);
      const Rectangle body = bodyOf(robot, layout.start);
      CHECK(clearance(body, innerContour(*field)) >= -1e-9);
      CHECK(wallClearance(*field, layout.goal) >= robot.width / 2);
      for (const ObstacleSpec& o : layout.obstacles) {
        CHECK(clearance(body, o, o.pose) > 0.0);
        CHECK(distance(o.pose.position, layout.goal) > o.radius + robot.width / 2);
        CHECK(wallClearance(*field, o.pose.position) >= o.radius - 1e-9);
      }
    }
  }
}

TEST_CASE("a layout is a pure function of seed and number", "[unit]") {
  for (const Suite& suite : suites()) {
    CHECK(toToml(suite.layout(3, 11)) == toToml(suite.layout(3, 11)));
    const bool drawn = suite.name != "cases" && suite.name != "sweeps";
    CHECK((toToml(suite.layout(3, 11)) != toToml(suite.layout(4, 11))) == drawn);
  }
}

TEST_CASE("corner layouts are the paper's setting", "[unit]") {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Layout layout = cornerLayout(2015, i);
    CHECK(layout.obstacles.size() == 4);
    CHECK(distance(layout.start.position, layout.goal) == Approx(std::sqrt(1.26 * 1.26 + 1.06 * 1.06)));
    int lower_left = 0;
    for (const ObstacleSpec& o : layout.obstacles) lower_left += o.pose.position.x < 0.0 ? 1 : 0;
    CHECK(lower_left == 2);
  }
}

TEST_CASE("the barrier of a clutter layout has one gap of the stated width and no other that a robot fits",
          "[unit]") {
  for (std::uint64_t i = 0; i < 40; i += 2) {
    const Layout layout = clutter13Layout(5, i);
    int passable = 0;
    double widest = 0.0;
    for (std::size_t k = 1; k < layout.obstacles.size(); ++k) {
      const double gap =
          distance(layout.obstacles[k].pose.position, layout.obstacles[k - 1].pose.position) - 0.075;
      passable += gap >= 0.075 ? 1 : 0;
      widest = std::max(widest, gap);
    }
    CHECK(passable == 1);
    CHECK(widest == Approx(1.3 * 0.075));
  }
}

TEST_CASE("the paper's figures are all there as named cases", "[unit]") {
  std::set<std::string> names;
  for (const Layout& layout : namedCases()) names.insert(layout.name);
  for (const char* name :
       {"fig1-abrupt-turns", "fig2a-ball-in-offset", "fig2b-repulsion-after-passing", "fig3-needless-motion",
        "fig4-wall", "fig5-corner", "fig6-two-turns", "fig7-close-obstacle", "fig8-close-obstacles"}) {
    CHECK(names.count(name) == 1);
  }
}

TEST_CASE("an unknown suite gets a suggestion", "[unit]") {
  const auto suite = findSuite("cornr");
  REQUIRE_FALSE(suite);
  CHECK(suite.error().code == ErrorCode::kUsage);
  CHECK(suite.error().message == "there is no suite 'cornr'. Did you mean 'corner'?");
}

}  // namespace fulbito
