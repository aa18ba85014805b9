// Drives the commands of recorded runs (tests/unit/engine/sim/recorded) with the profiles' own steps, and
// compares paths and yaw rates. Also fits two keys to all runs but one and tests that one.
#include <array>

#include "tests/unit/engine/sim/recorded/runs.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

Runs firasimRuns() {
  Runs runs = recorded("firasim-drive.csv", 3);
  REQUIRE(runs.size() == 10);
  runs.merge(recorded("firasim-free-driving.csv", 3));
  REQUIRE(runs.size() == 14);
  return runs;
}

/// `standard` with steps at the recorded frames, so that commands act at their times.
PhysicsProfile inFrames() {
  PhysicsProfile physics = standardPhysics();
  physics.name = "two steps a frame";
  physics.control_rate = 125;
  physics.substeps = 1;
  return physics;
}

double total(const Runs& runs, const RobotModel& robot, const PhysicsProfile& physics) {
  double sum = 0.0;
  for (const auto& [name, run] : runs) {
    const Comparison result = compare(run, driven(run, robot, physics));
    sum += std::min(result.off / result.allowed, 2.0) + std::min(result.yaw, 2.0);
  }
  return sum;
}

using Key = double RobotModel::*;

/// `robot` with the two keys scaled, by a few per cent, to fit `runs` best.
RobotModel fitted(const RobotModel& robot, Key first, Key second, const Runs& runs,
                  const PhysicsProfile& physics) {
  RobotModel best = robot;
  double least = INFINITY;
  for (const double a : {0.96, 0.98, 1.0, 1.02, 1.04}) {
    for (const double b : {0.96, 0.98, 1.0, 1.02, 1.04}) {
      RobotModel model = robot;
      model.*first *= a;
      model.*second *= b;
      const double sum = total(runs, model, physics);
      if (sum < least) least = sum, best = model;
    }
  }
  return best;
}

/// Number of runs that agree if the keys are fitted to all other runs.
int agreeLeftOut(const Runs& runs, const RobotModel& robot, Key first, Key second,
                 const PhysicsProfile& physics) {
  int agree = 0;
  for (const auto& [name, run] : runs) {
    Runs others = runs;
    others.erase(name);
    const RobotModel model = fitted(robot, first, second, others, physics);
    const Comparison result = compare(run, driven(run, model, physics));
    UNSCOPED_INFO("left out " << name << ": " << model.*first << ", " << model.*second << "; off "
                              << 1e3 * result.off << " mm of " << 1e3 * result.allowed << ", yaw "
                              << result.yaw << (result.agrees() ? "" : " *"));
    agree += result.agrees() ? 1 : 0;
  }
  return agree;
}

}  // namespace

TEST_CASE("the vsss robot drives as the recorded ones of its simulator", "[unit]") {
  const Runs runs = recorded("rsim-free-driving.csv", 2);
  REQUIRE(runs.size() == 6);
  const RobotModel robot = vsssPreset().robot;
  CHECK(runsThatAgree(runs, robot, standardPhysics()) >= 5);
  CHECK(runsThatAgree(runs, robot, inFrames()) >= 5);
  CHECK(runsThatAgree(runs, robot, faithfulPhysics()) >= 5);
  // With steps of 16.7 ms, commands act up to that much late.
  CHECK(runsThatAgree(runs, robot, fastPhysics()) >= 3);
}

TEST_CASE("the firasim robot drives as the recorded ones of its simulator", "[unit]") {
  const Runs runs = firasimRuns();
  const RobotModel robot = firasimPreset().robot;
  CHECK(runsThatAgree(runs, robot, standardPhysics()) >= 13);
  CHECK(runsThatAgree(runs, robot, inFrames()) >= 13);
  CHECK(runsThatAgree(runs, robot, faithfulPhysics()) >= 13);
  CHECK(runsThatAgree(runs, robot, fastPhysics()) >= 11);
}

TEST_CASE("the firasim robot drives as the rebuilt one, at commands that nothing was fitted to", "[unit]") {
  const Runs runs = recorded("firasim-rebuilt.csv", 1);
  REQUIRE(runs.size() == 36);
  Runs held, changed;
  for (const auto& run : runs) (run.first.starts_with("held") ? held : changed).insert(run);
  const RobotModel robot = firasimPreset().robot;
  for (const PhysicsProfile& physics : {standardPhysics(), faithfulPhysics(), fastPhysics()})
    CHECK(runsThatAgree(held, robot, physics) == 6);
  // Most of these runs brake hard. With such coarse steps, even the rebuilt robot agrees with only two thirds
  // of its runs.
  CHECK(runsThatAgree(changed, robot, standardPhysics()) >= 17);
  CHECK(runsThatAgree(changed, robot, faithfulPhysics()) >= 18);
  CHECK(runsThatAgree(changed, robot, fastPhysics()) >= 8);
}

TEST_CASE("robots fitted to all recorded runs but one drive that one as well", "[unit]") {
  CHECK(agreeLeftOut(firasimRuns(), firasimPreset().robot, &RobotModel::yaw_acceleration,
                     &RobotModel::longitudinal_grip, standardPhysics()) >= 12);
  CHECK(agreeLeftOut(recorded("rsim-free-driving.csv", 2), vsssPreset().robot,
                     &RobotModel::wheel_acceleration, &RobotModel::lateral_grip, standardPhysics()) >= 5);
}
