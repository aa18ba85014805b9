#include "referee/geometry/areas.hpp"

#include <cmath>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

/// Share of the body in the area, by a grid of points: independent of the exact computation.
double shareByGrid(const AreaShape& area, const AreaBody& body, int cells) {
  int inside = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double u = (2.0 * (i + 0.5) / cells - 1.0) * body.half_length;
      const double v = (2.0 * (j + 0.5) / cells - 1.0) * body.half_width;
      if (contains(area, body.centre + outOfFrame(body.x_axis, {u, v}))) ++inside;
    }
  }
  return static_cast<double>(inside) / (cells * cells);
}

AreaBody randomBody(Rng& rng) {
  const double heading = rng.uniform(-math::kPi, math::kPi);
  return {{rng.uniform(-0.1, 0.3), rng.uniform(-0.45, 0.45)},
          math::unit(heading),
          rng.uniform(0.02, 0.06),
          rng.uniform(0.02, 0.06)};
}

}  // namespace

TEST_CASE("share and overlap agree with a count of points", "[unit]") {
  Rng rng(1, test::kTestStream);
  for (const bool arc : {true, false}) {
    const AreaShape area = goalAreaOf(FieldGeometry{}, arc);
    for (int i = 0; i < 3000; ++i) {
      const AreaBody body = randomBody(rng);
      const double share = shareInside(area, body), counted = shareByGrid(area, body, 40);
      CAPTURE(body.centre.x, body.centre.y, body.half_length, body.half_width);
      REQUIRE(std::abs(share - counted) < 0.02);
      if (counted > 0.0) REQUIRE(overlaps(area, body));
      if (!overlaps(area, body)) REQUIRE(share == Approx(0.0).margin(1e-12));
      if (std::abs(share - 0.5) > 1e-9) {
        REQUIRE(counts(area, body, BodyPart::kHalf) == (share > 0.5));
      }
      REQUIRE(counts(area, body, BodyPart::kAnyPart) == overlaps(area, body));
      REQUIRE(counts(area, body, BodyPart::kCentre) == contains(area, body.centre));
    }
  }
}

TEST_CASE("the report counts by team and side, and by what the rules count", "[unit]") {
  const FieldGeometry field;
  const RobotModel robot;
  const std::vector<RobotId> ids = {
      {TeamId::kBlue, 0}, {TeamId::kBlue, 1}, {TeamId::kYellow, 0}, {TeamId::kYellow, 1}};
  std::vector<RobotState> robots(4);
  robots[0].pose.position = {-0.70, 0.0};
  robots[1].pose.position = {0.57, 0.25};  // 7.5 mm of it inside: any part, not half
  robots[2].pose.position = {0.70, 0.0};
  robots[3].pose.position = {0.595, -0.25};  // less than half
  BallState ball;
  ball.position = {0.62, 0.0};
  const MatchView view{1, ids, robots, ball, {}};
  AreaRules rules;
  const AreaReport report = reportAreas(view, field, robot, rules, Side::kLeft, {});
  CHECK(report[0].defenders == 1U);
  CHECK(report[0].attackers == 0U);
  CHECK_FALSE(report[0].ball);
  CHECK(report[1].attackers == 2U);
  CHECK(report[1].defenders == 4U);
  CHECK(report[1].ball);
  CHECK(report[1].big_attackers == 0U);
  const AreaReport swapped = reportAreas(view, field, robot, rules, Side::kRight, {});
  CHECK(swapped[0].attackers == 1U);
  CHECK(swapped[1].attackers == 4U + 8U);
  CHECK(swapped[1].defenders == 0U);
  rules.attackers_part = rules.defenders_part = BodyPart::kCentre;
  CHECK(reportAreas(view, field, robot, rules, Side::kLeft, {})[1].attackers == 0U);
}

TEST_CASE("a robot that is inside counts until it has left the grown area", "[unit]") {
  const FieldGeometry field;
  const std::vector<RobotId> ids = {{TeamId::kBlue, 1}};
  std::vector<RobotState> robots(1);
  AreaRules rules;
  rules.hysteresis = 0.002;
  AreaReport report{};
  const auto insideAt = [&](double x) {
    robots[0].pose.position = {x, 0.25};
    report = reportAreas({1, ids, robots, {}, {}}, field, RobotModel{}, rules, Side::kLeft, report);
    return report[1].attackers != 0;
  };
  CHECK_FALSE(insideAt(0.5615));
  CHECK(insideAt(0.5635));
  CHECK(insideAt(0.5615));
  CHECK_FALSE(insideAt(0.5595));
  CHECK_FALSE(insideAt(0.5615));
}

TEST_CASE("states that are not finite are in no area and harm nothing", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<RobotId> ids = {{TeamId::kBlue, 0}, {TeamId::kYellow, 0}};
  std::vector<RobotState> robots(2);
  robots[0].pose = {{nan, nan}, nan};
  robots[1].pose = {{0.7, 0.0}, nan};
  BallState ball;
  ball.position = {nan, 0.0};
  const AreaReport report =
      reportAreas({1, ids, robots, ball, {}}, FieldGeometry{}, RobotModel{}, {}, Side::kLeft, {});
  CHECK_FALSE(report[0].ball);
  CHECK_FALSE(report[1].ball);
  CHECK(report[0].attackers == 0U);
}

}  // namespace fulbito
