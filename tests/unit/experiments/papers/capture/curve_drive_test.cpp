#include "experiments/papers/capture/curve_drive.hpp"

#include <cmath>

#include "experiments/papers/capture/circle_fit.hpp"
#include "experiments/papers/capture/curve_table.hpp"
#include "experiments/papers/capture/paper_tables.hpp"
#include "experiments/papers/capture/slip_fit.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::capture {
namespace {

CurveDriveSetup setupOf(double speed, bool twice) {
  CurveDriveSetup setup;
  setup.robot = loadRobot("choi-lee-2005")->robot;
  setup.speed = speed;
  setup.twice = twice;
  setup.radius = twice ? PaperTables::kDoubleRadius : PaperTables::kSingleRadius;
  return setup;
}

}  // namespace

// Misprint: (2) prints twice the yaw rate. It would halve every radius of Table 4.
TEST_CASE("wheels at plus and minus 1 m/s turn the robot by 2 / track, not 4 / track", "[unit]") {
  const RobotModel robot = loadRobot("choi-lee-2005")->robot;
  const double wheel = 1.0 / robot.wheel_radius;
  CHECK(forwardKinematics(robot, {-wheel, wheel}).angular == Approx(2.0 / 0.4));
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const PaperTables::Computed& row = PaperTables::kComputed[i];
    const Twist twist = forwardKinematics(
        robot, {row.single_left / robot.wheel_radius, row.single_right / robot.wheel_radius});
    CHECK(twist.linear == Approx(PaperTables::kSpeeds[i]));
    const double radius = twist.linear / std::abs(twist.angular);
    CHECK(radius == Approx(3.75).epsilon(0.07));  // three printed digits
    CHECK(radius / 2 < 2.1);                      // by (2) as printed
  }
}

TEST_CASE("wheel speeds of Table 4 follow from radius and track", "[unit]") {
  const RobotModel robot = loadRobot("choi-lee-2005")->robot;
  const auto rims = [&](double v, double r) {
    const WheelSpeeds wheels = inverseKinematics(robot, {v, v / r});
    return Vec2{wheels.left * robot.wheel_radius, wheels.right * robot.wheel_radius};
  };
  CHECK(rims(0.5, 3.75).y == Approx(0.5267).epsilon(1e-4));
  CHECK(rims(0.5, 3.75).x == Approx(0.4733).epsilon(1e-4));
  CHECK(rims(0.5, 1.875).y == Approx(0.5533).epsilon(1e-4));
  CHECK(rims(0.5, 1.875).x == Approx(0.4467).epsilon(1e-4));
}

// The paper gives no formula: Table 4's time is d / v + v / 2a, cut to a tenth.
TEST_CASE("a robot without slip that starts from rest takes the time of Table 4", "[unit]") {
  CurveDriveSetup setup = setupOf(0.5, false);
  setup.robot.curve_widening = setup.robot.curve_widening_rise = 0.0;
  setup.from_rest = true;
  const auto driven = driveCurve(setup);
  REQUIRE(driven);
  CHECK(driven->time == Approx(7.176 / 0.5 + 0.5 / 0.1).margin(0.02));
  CHECK(std::floor(driven->time * 10) / 10 == Approx(19.3));
  CHECK(driven->radius1 == Approx(3.75).epsilon(1e-4));
  CHECK(driven->end_error < 0.01);
}

TEST_CASE("the robot drives the radii of Tables 5 and 6 in the world", "[unit]") {
  const auto single = driveCurve(setupOf(0.5, false)), both = driveCurve(setupOf(0.5, true));
  REQUIRE(single);
  REQUIRE(both);
  CHECK(single->radius1 == Approx(3.75 + 1.319 * 0.5 + 2.41 * 0.25).epsilon(1e-3));
  CHECK(both->radius1 == Approx(1.875 + 1.319 * 0.5 + 2.41 * 0.25).epsilon(1e-3));
  CHECK(both->radius2 == Approx(both->radius1).epsilon(1e-3));
  CHECK(single->radius1 == Approx(4.98).margin(0.06));
  CHECK(single->distance == Approx(8.32).margin(0.1));
  CHECK(both->radius1 == Approx(3.12).margin(0.11));
  CHECK(both->radius2 == Approx(3.15).margin(0.11));
  CHECK(both->end_error / single->end_error > 1.7);
}

// The two columns have the same name, but only the errors of Table 5 are errors of the radius.
TEST_CASE("the error column is of the radius in Table 5 and of something else in Table 6", "[unit]") {
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const PaperTables::Single& one = PaperTables::kSingle[i];
    CHECK(one.radius - 3.75 == Approx(one.error).margin(1e-9));
    const PaperTables::Double& two = PaperTables::kDouble[i];
    CHECK(two.error - (two.radius1 + two.radius2 - 3.75) > 0.15);
  }
}

// Misprint: with k = 1 / r from (13), the force in (14) would fall with the square of the radius.
TEST_CASE("the side force of a curve is m v^2 / r, far below the grip", "[unit]") {
  const RobotModel robot = loadRobot("choi-lee-2005")->robot;
  const double needed = 0.5 * 0.5 / 1.875;  // [m/s^2] in the tightest curve
  CHECK(needed < 0.1 * robot.lateral_grip);
  const auto driven = driveCurve(setupOf(0.5, true));
  REQUIRE(driven);
  // Measured in the world: the direction of the velocity turns at the rate v / r.
  const std::size_t n = 100;
  const Vec2 before = driven->trace[n].position - driven->trace[n - 1].position;
  const Vec2 after = driven->trace[n + 1].position - driven->trace[n].position;
  const double force = robot.mass * norm(after - before) * 60 * 60;
  CHECK(force == Approx(robot.mass * 0.25 / driven->radius1).epsilon(0.02));
}

TEST_CASE("the calibrated widening is the least-squares fit to Tables 5 and 6", "[unit]") {
  const RobotModel robot = loadRobot("choi-lee-2005")->robot;
  const SlipFit fit = fitWidening(publishedRadii());
  CHECK(fit.tau0 == Approx(robot.curve_widening).margin(5e-4));
  CHECK(fit.tau1 == Approx(robot.curve_widening_rise).margin(5e-4));
  CHECK(fit.rms == Approx(0.047).margin(0.001));
  CHECK(fit.worst == Approx(0.108).margin(0.001));
  CHECK(fitLinearWidening(publishedRadii()).rms == Approx(0.095).margin(0.001));
  CHECK(fitLinearWidening(publishedRadii()).tau0 == Approx(2.305).margin(0.001));
  CHECK(fitUndersteer(publishedRadii()).rms > 0.28);
}

TEST_CASE("a change at once is shorter by what both wheels need to change, in time and way", "[unit]") {
  for (const double speed : {0.25, 0.45}) {
    CurveDriveSetup setup = setupOf(speed, true);
    const auto gradual = driveCurve(setup);
    setup.instant_change = true;
    const auto instant = driveCurve(setup);
    REQUIRE(gradual);
    REQUIRE(instant);
    CHECK(instant->time < gradual->time - 0.5);
    CHECK(gradual->distance - instant->distance ==
          Approx(speed * (gradual->time - instant->time)).epsilon(0.02));
    CHECK(instant->radius1 == Approx(gradual->radius1).epsilon(1e-3));
    CHECK(instant->end_error < gradual->end_error);
  }
}

// The bands of Table 6: a radius 0.11 m larger makes the path 0.21 m longer and the end's error 0.28 m
// larger.
TEST_CASE("the bands of distance and error of Table 6 follow from that of its radii", "[unit]") {
  CurveDriveSetup setup = setupOf(0.1, true);
  const auto driven = driveCurve(setup);
  setup.robot.curve_widening += 0.11 / setup.speed;
  const auto wider = driveCurve(setup);
  REQUIRE(driven);
  REQUIRE(wider);
  CHECK(wider->radius1 - driven->radius1 == Approx(0.11).margin(0.002));
  CHECK(wider->distance - driven->distance == Approx(0.21).margin(0.01));
  CHECK(wider->end_error - driven->end_error == Approx(0.28).margin(0.01));
}

// Erratum: (t - v / 2a) v is the distance of a robot at constant speed.
TEST_CASE("times and distances agree in Table 5 and contradict each other in Table 6", "[unit]") {
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    const auto way = [&](double time) { return (time - v / 0.1) * v; };
    CHECK(std::abs(way(PaperTables::kSingle[i].time) - PaperTables::kSingle[i].distance) < 0.08);
    const double off = way(PaperTables::kDouble[i].time) - PaperTables::kDouble[i].distance;
    CHECK((std::abs(off) < 0.2) == (v < 0.25));
    if (v > 0.25) CHECK(off > 0.6);
  }
}

TEST_CASE("a law is judged on radii that it has not seen", "[unit]") {
  std::vector<DrivenRadius> made, unseen;
  for (const double v : {0.15, 0.35, 0.6}) made.push_back({v, 1.0, 1.0 + 0.8 * v + 1.7 * v * v});
  for (const double v : {0.22, 0.7}) unseen.push_back({v, 2.0, 2.0 + 0.8 * v + 1.7 * v * v});
  const SlipFit law = fitWidening(made);
  CHECK(judgedOn(law, unseen).worst < 1e-9);
  unseen.push_back({0.5, 2.0, 2.0 + 0.8 * 0.5 + 1.7 * 0.25 - 0.3});
  CHECK(judgedOn(law, unseen).worst == Approx(0.3));
  CHECK(judgedOn(law, unseen).rms == Approx(0.3 / std::sqrt(3.0)));
  // On its own radii, a fit has the same errors as before.
  CHECK(judgedOn(fitWidening(radiiOfTable6()), radiiOfTable6()).worst ==
        Approx(fitWidening(radiiOfTable6()).worst));
}

TEST_CASE("the error of a curve grows with the speed and with a smaller radius", "[unit]") {
  const auto errors = driveCurveErrors(loadRobot("choi-lee-2005")->robot);
  REQUIRE(errors);
  const std::size_t speeds = PaperTables::kSpeeds.size();
  REQUIRE(errors->size() == 4 * speeds);
  for (std::size_t i = 0; i < errors->size(); ++i) {
    const CurveError& error = (*errors)[i];
    if (i % speeds > 0) CHECK(error.error > (*errors)[i - 1].error);
    if (i >= speeds) CHECK(error.error < (*errors)[i - speeds].error);
  }
}

TEST_CASE("a circle is fitted to points of an arc", "[unit]") {
  std::vector<Vec2> points;
  for (int i = 0; i < 20; ++i) points.push_back(Vec2{3.0, -1.0} + math::unit(0.05 * i) * 4.0);
  const FittedCircle circle = fitCircle(points);
  CHECK(circle.radius == Approx(4.0));
  CHECK(circle.centre.x == Approx(3.0));
  CHECK(circle.centre.y == Approx(-1.0));
}

}  // namespace fulbito::capture
