#include "experiments/papers/transport/carrying.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "experiments/papers/transport/constraint_curve.hpp"
#include "experiments/papers/transport/path_file.hpp"
#include "experiments/papers/transport/path_fit.hpp"
#include "experiments/papers/transport/random_path.hpp"

namespace fulbito {
namespace {

/// A row of an independently computed table of the S path, in cm and s.
struct Golden {
  double time;
  SwitchCause cause;
  CarrierId master;
  double direction, lead, follower;
};

constexpr Golden kGolden[] = {{91.37, SwitchCause::kSpeed, CarrierId::kFollower, 1, 810.9, 34.2},
                              {107.4, SwitchCause::kPartEnd, CarrierId::kLead, -1, 778.8, 162.2},
                              {137.1, SwitchCause::kPartEnd, CarrierId::kFollower, 1, 541.3, 399.7},
                              {174.4, SwitchCause::kPartEnd, CarrierId::kLead, 1, 778.5, 698.5},
                              {213.9, SwitchCause::kPartEnd, CarrierId::kFollower, -1, 1094.3, 478.9},
                              {215.2, SwitchCause::kSpeed, CarrierId::kLead, 1, 1106.0, 468.5},
                              {230.4, SwitchCause::kSpeed, CarrierId::kFollower, 1, 1227.6, 450.8}};

CarryPlan withStep(double step) {
  CarryPlan plan;
  plan.step = step;
  return plan;
}

CarryPlan withOutage(double from, double to, bool lead, bool follower) {
  CarryPlan plan;
  plan.radio.outages.push_back({from, to, lead, follower});
  return plan;
}

Carrying carryS(const CarryPlan& plan) { return carry(builtInTransport("s-path"), plan); }

}  // namespace

TEST_CASE("the S path: seven exchanges of roles, each within a centimetre of its place", "[unit]") {
  for (const double step : {0.01, 0.05, 0.1}) {
    const Carrying work = carryS(withStep(step));
    CHECK(work.end == StopReason::kArrived);
    REQUIRE(work.switches.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
      CHECK(work.switches[i].cause == kGolden[i].cause);
      CHECK(work.switches[i].master == kGolden[i].master);
      CHECK(work.switches[i].direction == kGolden[i].direction);
      CHECK(std::abs(100 * work.switches[i].lead - kGolden[i].lead) < 1.0);
      CHECK(std::abs(100 * work.switches[i].follower - kGolden[i].follower) < 1.0);
      CHECK(std::abs(work.switches[i].time - kGolden[i].time) < 0.2);
    }
    CHECK(work.peak_speed <= 0.1 * (1 + 1e-8));
    CHECK(work.seconds == Approx(321.2).margin(0.1));
    CHECK(work.lead_way == Approx(24.16).margin(0.02));
    CHECK(work.follower_way == Approx(24.16).margin(0.02));
  }
}

TEST_CASE("seven exchanges also with steps of half a second", "[unit]") {
  CHECK(carryS(withStep(0.2)).switches.size() == 7);
  CHECK(carryS(withStep(0.5)).switches.size() == 7);
}

TEST_CASE("projection keeps the rod's length; the relation alone drifts with the step", "[unit]") {
  const Carrying projected = carryS(withStep(0.05));
  CHECK(projected.rod_error < 1e-4);
  CarryPlan plan = withStep(0.05);
  plan.habits.project = false;
  const Carrying euler = carryS(plan);
  CHECK(euler.rod_error == Approx(0.0044).margin(0.0002));
  plan.step = 0.1;
  CHECK(carryS(plan).rod_error == Approx(2 * euler.rod_error).epsilon(0.1));
}

TEST_CASE("three of the seven exchanges of the S path are due to speed, four to ends of parts", "[unit]") {
  int by_speed = 0;
  for (const RoleSwitch& s : carryS({}).switches) by_speed += s.cause == SwitchCause::kSpeed ? 1 : 0;
  CHECK(by_speed == 3);
}

TEST_CASE("the new master goes on in the direction in which it went", "[unit]") {
  CarryPlan plan;
  plan.keep_rows = true;
  const TransportTask task = builtInTransport("maze");
  const Carrying work = carry(task, plan);
  REQUIRE(work.end == StopReason::kArrived);
  std::size_t row = 0;
  for (const RoleSwitch& s : work.switches) {
    while (row + 1 < work.rows.size() && work.rows[row + 1].time < s.time) ++row;
    const double before =
        s.master == CarrierId::kLead ? work.rows[row].lead_speed : work.rows[row].follower_speed;
    // At a corner a robot that hardly moves may turn.
    if (std::abs(before) > 0.01) CHECK(before * s.direction > 0.0);
  }
}

TEST_CASE("the long path of 43 parts is carried to its end", "[unit]") {
  const Carrying work = carry(builtInTransport("maze"), {});
  CHECK(work.end == StopReason::kArrived);
  CHECK(work.rod_error < 1e-3);
  CHECK(work.peak_speed <= 0.1 * (1 + 1e-8));
  CHECK(work.switches.size() > 43);
}

TEST_CASE("by the printed rules the long path ends in a deadlock, whatever the step", "[unit]") {
  for (const double step : {0.03, 0.08}) {
    for (const bool project : {false, true}) {
      CarryPlan plan = withStep(step);
      plan.habits = {project, false};
      const TransportTask task = builtInTransport("maze");
      const Carrying work = carry(task, plan);
      CHECK(work.end == StopReason::kDeadlock);
      CHECK(work.lead < 0.6 * task.path.length());
      plan.habits.slow = true;
      if (project) CHECK(carry(task, plan).end == StopReason::kArrived);
    }
  }
}

TEST_CASE("the S path as a polyline is fitted and carried", "[unit]") {
  TransportTask task = builtInTransport("s-path");
  std::vector<Vec2> points;
  for (int i = 0; i <= 500; ++i) points.push_back(task.path.pose(task.path.length() * i / 500).position);
  task.path = fitPath(points).value();
  task.lead = rodLengthAhead(task.path, 0.0, task.rod).value();
  const Carrying work = carry(task, {});
  CHECK(work.end == StopReason::kArrived);
  CHECK(work.rod_error < 1e-3);
  CHECK(work.switches.size() >= 7);
}

TEST_CASE("random paths are carried exactly if the curve arrives", "[unit]") {
  int deadlocks = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const TransportTask task = randomTransport(77, i);
    const bool arrives = traceCurve(task).arrives();
    const Carrying work = carry(task, {});
    CHECK((work.end == StopReason::kArrived) == arrives);
    if (!arrives) CHECK(work.end == StopReason::kOffPath);
    CHECK(work.rod_error < 1e-3);
    CHECK(work.peak_speed <= 0.1 * (1 + 1e-8));
    CarryPlan printed;
    printed.habits.slow = false;
    deadlocks += carry(task, printed).end == StopReason::kDeadlock ? 1 : 0;
  }
  // With the printed rules the robots exchange roles without progress: docs/papers.md.
  CHECK(deadlocks > 0);
}

TEST_CASE("lost and late messages cost time, not the rod", "[unit]") {
  for (const RadioModel& radio :
       {RadioModel{0.1, 0.0, {}}, RadioModel{0.3, 0.0, {}}, RadioModel{0.1, 0.003, {}}}) {
    CarryPlan plan;
    plan.radio = radio;
    const Carrying work = carryS(plan);
    CHECK(work.end == StopReason::kArrived);
    CHECK(work.switches.size() == 7);
    CHECK(work.rod_error < 1e-3);
    CHECK(work.lost > work.messages / 20);
    CHECK(work.seconds > 321.2);
  }
}

TEST_CASE("at any instant a cut in either direction stops both robots in time, and they go on", "[unit]") {
  for (int i = 0; i < 4; ++i) {
    const double from = 91.253 + 0.0213 * i;  // includes the first exchange of roles
    for (const auto& [lead, follower] : {std::pair{true, true}, {true, false}, {false, true}}) {
      const Carrying work = carryS(withOutage(from, from + 2.0, lead, follower));
      CHECK(work.end == StopReason::kArrived);
      CHECK(work.rod_error < 1e-3);
      CHECK(work.timeouts >= 1);
      CHECK(work.seconds > 323.0);
    }
  }
}

TEST_CASE("both robots stand still during silence", "[unit]") {
  CarryPlan plan = withOutage(50.0, 55.0, true, true);
  plan.keep_rows = true;
  const Carrying work = carryS(plan);
  CHECK(work.timeouts == 2);
  for (const CarryRow& row : work.rows) CHECK((row.time < 50.01 || row.time > 55.0));
}

TEST_CASE("robots that never hear each other again give up", "[unit]") {
  const Carrying work = carryS(withOutage(20.0, 1e9, true, true));
  CHECK(work.end == StopReason::kSilence);
  CHECK(work.seconds < 60.0);
  CHECK(work.rod_error < 1e-3);
}

TEST_CASE("a slow radio slows the robots: alone none goes farther than 0.6 mm", "[unit]") {
  CarrierTimes times;
  const TransportTask task = builtInTransport("s-path");
  CHECK(safeSpeedShare(task, times) == 1.0);
  times.delay = 0.02;
  const double share = safeSpeedShare(task, times);
  CHECK(share * task.max_speed * (times.patience + times.delay) == Approx(0.0006));
}

TEST_CASE("the same seed loses the same messages, another one others", "[unit]") {
  CarryPlan plan;
  plan.radio.loss = 0.2;
  const Carrying one = carryS(plan), two = carryS(plan);
  plan.seed = 2;
  const Carrying other = carryS(plan);
  CHECK(one.messages == two.messages);
  CHECK(one.lost == two.lost);
  CHECK(one.seconds == two.seconds);
  CHECK(one.lost != other.lost);
}

TEST_CASE("late messages arrive in the order of their times", "[unit]") {
  Radio radio({0.0, 0.5, {}}, 1, 0);
  for (int i = 0; i < 20; ++i) radio.send(CarrierId::kLead, {}, 0.01 * i);
  double last = 0.0;
  for (int i = 0; i < 20; ++i) {
    CHECK(radio.next() >= last);
    CHECK(radio.next() >= 0.25);
    last = radio.next();
    radio.take();
  }
  CHECK(std::isinf(radio.next()));
}

}  // namespace fulbito
