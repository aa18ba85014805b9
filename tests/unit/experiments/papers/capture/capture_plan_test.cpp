#include "experiments/papers/capture/capture_plan.hpp"

#include <cmath>

#include "experiments/papers/capture/fig18.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;

CaptureTask paperTask(double gap) { return {fig18Robot(), fig18Object(), gap}; }

/// The object's position relative to the robot at the end of the plan: along the object's line and across it.
Vec2 objectAtEnd(const CapturePlan& plan, const ObjectMotion& object) {
  const double time = plan.motion.duration();
  const Vec2 line = unitOr(object.velocity, {}), to = object.at(time) - plan.motion.end().pose.position;
  return {dot(line, to), cross(line, to)};
}

}  // namespace

// Misprint: (23) compares a speed with an acceleration. With a time of 1 s it gives the experiment's values.
TEST_CASE("speed and straightening within a second bind at the radius of the paper's experiment", "[unit]") {
  const CaptureLimits limits;
  CHECK(limits.largestFirstRadius() == Approx(2.6));
  CHECK(limits.largestTurn(2.6) == Approx(84.22 * kDegree).epsilon(1e-4));
  const CaptureStart start = captureStart(limits, fig18Robot(), -1.0, 2.6, limits.largestTurn(2.6));
  CHECK(start.time == Approx(14.0));
  CHECK(start.top_speed == Approx(0.546));
  const double yaw = start.top_speed / 2.6;
  const double outer = start.top_speed + yaw * 0.2, inner = start.top_speed - yaw * 0.2;
  CHECK(outer == Approx(0.588));
  CHECK(inner == Approx(0.504));
  CHECK(outer - inner == Approx(2 * 0.042 * 1.0));
  CHECK(inner / start.time == Approx(0.036));                  // the acceleration of the inner wheel
  CHECK(start.motion.duration() - start.time == Approx(1.0));  // duration of straightening
  CHECK(limits.largestTurn(1.0) < limits.largestTurn(2.6));
  // for larger turns the wheel's speed is the limit
  CHECK(limits.largestTurn(4.0) == Approx(0.042 * 14 * 14 / 2 / 4.2));
}

TEST_CASE("the first curve is an arc of the wanted turn, and straightening turns on by half its yaw rate",
          "[unit]") {
  const CaptureStart start = captureStart(CaptureLimits{}, fig18Robot(), -1.0, 2.0, 1.0);
  const MotionState end = start.motion.at(start.time);
  CHECK(end.pose.heading == Approx(math::kPi / 2 - 1.0));
  CHECK(end.pose.position.x == Approx(1.0 + 2.0 * (1 - math::cos(1.0))));
  CHECK(end.pose.position.y == Approx(2.0 + 2.0 * math::sin(1.0)));
  const double yaw = start.top_speed / 2.0, time = yaw * 0.4 / (2 * 0.042);
  CHECK(start.motion.duration() - start.time == Approx(time));
  CHECK(start.motion.end().pose.heading == Approx(math::kPi / 2 - 1.0 - yaw * time / 2));
}

TEST_CASE("plans of the paper's capture take these times and leave these gaps", "[unit]") {
  struct Row {
    double turn, time, gap;
  };
  // From an independent computation that treats the straightening as an arc.
  for (const Row row :
       {Row{84.22, 27.27, 0.149}, {80.01, 29.01, 0.244}, {75.80, 31.25, 0.324}, {71.59, 34.28, 0.392}}) {
    const auto plan = capturePlan(fig18Limits(), paperTask(0.0), -1.0, 2.6, row.turn * kDegree, 2.4);
    REQUIRE(plan);
    CHECK(plan->motion.duration() == Approx(row.time).margin(0.06));
    CHECK(plan->gap == Approx(row.gap).margin(0.006));
  }
}

TEST_CASE("a plan ends on the object's line, along it, at its speed, with the wanted gap", "[unit]") {
  for (const double gap : {0.16, 0.24, 0.32}) {
    const CaptureAnswer answer = planCapture(fig18Limits(), paperTask(gap));
    REQUIRE(answer.plan);
    const Vec2 object = objectAtEnd(*answer.plan, fig18Object());
    CHECK(object.x == Approx(gap).margin(2e-4));
    CHECK(object.y == Approx(0.0).margin(1e-9));
    const MotionState end = answer.plan->motion.end();
    CHECK(end.twist.linear == Approx(0.3));
    CHECK(end.pose.heading == Approx(40 * kDegree));
    CHECK(answer.plan->line >= (0.5 * 0.5 - 0.3 * 0.3) / (2 * 0.042));  // room to slow down
  }
}

// Misprint: (27) gives a minimum instead of a place. The test uses the place with the right gap.
TEST_CASE("slowing down later shortens the gap, and the right moment makes it exact", "[unit]") {
  const CaptureStart start = captureStart(fig18Limits(), fig18Robot(), -1.0, 2.6, 72 * kDegree);
  const auto at_once = captureEnd(fig18Limits(), start.motion, start.top_speed, fig18Object(), 2.4, 0.0);
  const auto late = captureEnd(fig18Limits(), start.motion, start.top_speed, fig18Object(), 2.4, 1.0);
  REQUIRE(at_once);
  REQUIRE(late);
  CHECK(late->gap < at_once->gap);
  const auto exact = replanEnd(fig18Limits(), start.motion, start.top_speed, fig18Object(), 2.4, 0.2);
  REQUIRE(exact);
  CHECK(exact->gap == Approx(0.2));
  CHECK(exact->radius3 == 2.4);
}

TEST_CASE("the planner says why it has no plan", "[unit]") {
  CaptureTask task = paperTask(0.24);
  task.object.velocity = math::unit(40 * kDegree) * 0.6;
  CHECK(planCapture(CaptureLimits{}, task).refusal == CaptureRefusal::kTooFast);
  task.object.velocity = {};
  CHECK(planCapture(CaptureLimits{}, task).refusal == CaptureRefusal::kTooFast);
  task = paperTask(0.24);
  task.object = {{1.0, 2.0}, {-0.3, 0.0}, 0.0};  // it moves away on a line that no first curve reaches
  const CaptureAnswer none = planCapture(CaptureLimits{}, task);
  CHECK_FALSE(none.plan);
  task = paperTask(0.24);
  task.object.position = {-1.0, -6.0};  // far behind
  CHECK_FALSE(planCapture(CaptureLimits{}, task).plan);
  CaptureLimits small;
  small.half_hall = 2.5;
  const CaptureAnswer out = planCapture(small, paperTask(0.24));
  CHECK_FALSE(out.plan);
  CHECK(out.refusal == CaptureRefusal::kTooLong);
  CaptureLimits wide;
  wide.clearance = 5.0;
  CHECK(planCapture(wide, paperTask(0.24)).refusal == CaptureRefusal::kCollides);
  CHECK(nameOf(CaptureRefusal::kTooFast) == "object too fast, or at rest");
  CHECK(nameOf(CaptureRefusal::kCollides) == "too near on the way");
}

TEST_CASE("a turned task has the turned plan", "[unit]") {
  CaptureTask task = paperTask(0.24);
  const auto plain = planCapture(fig18Limits(), task);
  task.robot = {{-1.0, -2.0}, -90 * kDegree};
  task.object = {{-2.0, 0.0}, -fig18Object().velocity, 0.0};
  const auto turned = planCapture(fig18Limits(), task);
  REQUIRE(plain.plan);
  REQUIRE(turned.plan);
  CHECK(turned.plan->turn1 == Approx(plain.plan->turn1));
  CHECK(turned.plan->motion.duration() == Approx(plain.plan->motion.duration()));
}

}  // namespace fulbito::capture
