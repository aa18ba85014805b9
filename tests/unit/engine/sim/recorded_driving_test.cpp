// Drives the commands of recorded runs (tests/unit/engine/sim/recorded) and compares ways and yaw rates.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kFrame = 0.016;      // [s]
constexpr double kFollowed = 1.0;     // [s] after which the ways are compared
constexpr double kYawShare = 0.10;    // of the recorded yaw rate
constexpr double kLeastYaw = 0.1;     // [rad/s] below which a share of it means nothing
constexpr double kWayShare = 0.05;    // of the way driven so far
constexpr double kLeastWay = 0.005;   // [m]
constexpr std::size_t kSettled = 12;  // frames of one command after which the step is over: 0.19 s

struct Sample {
  WheelSpeeds wheels;
  Pose2 pose;
};
using Run = std::vector<Sample>;

/// @param columns  where wheel speeds stand in a row; run is the first, pose follows the wheels
std::map<std::string, Run> recorded(const std::string& file, std::size_t columns) {
  std::ifstream text(std::string(FULBITO_RECORDED) + "/" + file);
  REQUIRE(text);
  std::map<std::string, Run> runs;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("run")) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    const auto number = [&](std::size_t i) { return std::stod(cells.at(columns + i)); };
    runs[cells[0]].push_back(
        {{number(0), number(1)}, {{number(2), number(3)}, number(4) * math::kPi / 180.0}});
  }
  return runs;
}

/// The robot's poses when it is given the run's commands, a sample a frame.
std::vector<Pose2> driven(const Run& run, const RobotModel& robot, PhysicsProfile physics) {
  physics.control_rate = 125;  // frames are two ticks
  WorldConfig config = loneRobot(robot, physics);
  config.robots[0].pose = run[0].pose;
  World world = makeWorld(config);
  std::vector<Pose2> poses{run[0].pose};
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    test::run(world, run[i].wheels, 2);
    poses.push_back(world.state().robots[0].pose);
  }
  return poses;
}

double yawRate(const Pose2& before, const Pose2& after) {
  return math::wrapAngle(after.heading - before.heading) / kFrame;
}

bool sameWheels(const Sample& a, const Sample& b) {
  return a.wheels.left == b.wheels.left && a.wheels.right == b.wheels.right;
}

struct Comparison {
  double off = 0.0;      // [m] after `kFollowed` or at the end
  double allowed = 0.0;  // [m]
  bool yaws_agree = true;
  std::string yaws;
};

Comparison compare(const Run& run, const std::vector<Pose2>& ours) {
  Comparison result;
  const std::size_t last = std::min(run.size() - 1, static_cast<std::size_t>(kFollowed / kFrame));
  double way = 0.0;
  for (std::size_t i = 0; i < last; ++i) way += distance(run[i].pose.position, run[i + 1].pose.position);
  result.off = distance(run[last].pose.position, ours[last].position);
  result.allowed = std::max(kWayShare * way, kLeastWay);
  std::size_t since = 0;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const bool ends = i + 1 == run.size() || !sameWheels(run[i], run[i - 1]);
    if (!ends) continue;
    if (i - since >= kSettled) {
      const double theirs = yawRate(run[i - 1].pose, run[i].pose), mine = yawRate(ours[i - 1], ours[i]);
      result.yaws += " " + std::to_string(mine) + "/" + std::to_string(theirs);
      result.yaws_agree &= std::abs(mine - theirs) <= std::max(kYawShare * std::abs(theirs), kLeastYaw);
    }
    since = i;
  }
  return result;
}

int runsThatAgree(const std::map<std::string, Run>& runs, const RobotModel& robot,
                  const PhysicsProfile& physics) {
  int agree = 0;
  for (const auto& [name, run] : runs) {
    const Comparison result = compare(run, driven(run, robot, physics));
    UNSCOPED_INFO(name << ": off " << 1e3 * result.off << " mm of " << 1e3 * result.allowed << ", yaw"
                       << result.yaws);
    agree += result.off <= result.allowed && result.yaws_agree ? 1 : 0;
  }
  return agree;
}

}  // namespace

TEST_CASE("the vsss robot drives as the recorded ones of its simulator", "[unit]") {
  const auto runs = recorded("rsim-free-driving.csv", 2);
  REQUIRE(runs.size() == 6);
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  // At one step of 8 ms a tick commands act up to half a step early.
  CHECK(runsThatAgree(runs, vsssPreset().robot, physics) >= (physics.name == "fast" ? 4 : 5));
}

TEST_CASE("the firasim robot drives as the recorded ones of its simulator", "[unit]") {
  const auto runs = recorded("firasim-drive.csv", 3);
  REQUIRE(runs.size() == 10);
  const auto physics = GENERATE(fastPhysics(), standardPhysics(), faithfulPhysics());
  CAPTURE(physics.name);
  CHECK(runsThatAgree(runs, firasimPreset().robot, physics) >= 9);
}
