#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

namespace fulbito::test {

inline constexpr double kFrame = 0.016;     ///< [s] between recorded samples
inline constexpr double kFollowed = 1.0;    ///< [s] after which the paths are compared
inline constexpr double kYawShare = 0.10;   ///< share of the recorded yaw rate
inline constexpr double kLeastYaw = 0.1;    ///< [rad/s] below this, the share has no meaning
inline constexpr double kWayShare = 0.05;   ///< share of the distance driven so far
inline constexpr double kLeastWay = 0.005;  ///< [m]
/// frames of one command after which its step response is over: 0.19 s
inline constexpr std::size_t kSettled = 12;

struct Sample {
  WheelSpeeds wheels;
  Pose2 pose;
};
using Run = std::vector<Sample>;
using Runs = std::map<std::string, Run>;

/// @param columns  index of the wheel speeds in a row; the first column is the run, the pose follows the
/// wheels
inline Runs recorded(const std::string& file, std::size_t columns) {
  std::ifstream text(std::string(FULBITO_RECORDED) + "/" + file);
  REQUIRE(text);
  Runs runs;
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

inline Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.position + (b.position - a.position) * share,
          a.heading + math::wrapAngle(b.heading - a.heading) * share};
}

/// The robot's poses at the samples' times if it gets the run's commands. The world uses the steps of
/// `physics`. In each step it obeys the command in force at the step's beginning.
inline std::vector<Pose2> driven(const Run& run, const RobotModel& robot, const PhysicsProfile& physics) {
  const PhysicsProfile stepped = readEachStep(physics);
  const double step = stepped.controlPeriod();
  WorldConfig config = loneRobot(robot, stepped);
  config.robots[0].pose = run[0].pose;
  World world = makeWorld(config);
  std::vector<Pose2> poses{run[0].pose};
  constexpr double kRounding = 1e-9;  // [s]
  for (int i = 0; poses.size() < run.size(); ++i) {
    const double begin = i * step;
    const auto frame = static_cast<std::size_t>((begin + kRounding) / kFrame);
    const Pose2 before = world.state().robots[0].pose;
    test::run(world, run[std::min(frame, run.size() - 1)].wheels, 1);
    while (poses.size() < run.size()) {
      const double when = static_cast<double>(poses.size()) * kFrame;
      if (when > begin + step + kRounding) break;
      poses.push_back(between(before, world.state().robots[0].pose, (when - begin) / step));
    }
  }
  return poses;
}

inline double yawRate(const Pose2& before, const Pose2& after) {
  return math::wrapAngle(after.heading - before.heading) / kFrame;
}

struct Comparison {
  double off = 0.0;      ///< [m] error of the position after `kFollowed` or at the end
  double allowed = 0.0;  ///< [m]
  double yaw = 0.0;      ///< largest error of the yaw rate at the end of a command, over the allowed one
  bool agrees() const { return off <= allowed && yaw <= 1.0; }
};

inline Comparison compare(const Run& run, const std::vector<Pose2>& ours) {
  Comparison result;
  const std::size_t last = std::min(run.size() - 1, static_cast<std::size_t>(kFollowed / kFrame));
  double way = 0.0;
  for (std::size_t i = 0; i < last; ++i) way += distance(run[i].pose.position, run[i + 1].pose.position);
  result.off = distance(run[last].pose.position, ours[last].position);
  result.allowed = std::max(kWayShare * way, kLeastWay);
  std::size_t since = 0;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const WheelSpeeds now = run[i].wheels, before = run[i - 1].wheels;
    if (i + 1 < run.size() && now.left == before.left && now.right == before.right) continue;
    if (i - since >= kSettled) {
      const double theirs = yawRate(run[i - 1].pose, run[i].pose), mine = yawRate(ours[i - 1], ours[i]);
      const double allowed = std::max(kYawShare * std::abs(theirs), kLeastYaw);
      result.yaw = std::max(result.yaw, std::abs(mine - theirs) / allowed);
    }
    since = i;
  }
  return result;
}

/// Number of runs that agree. The message of a failure lists each run.
inline int runsThatAgree(const Runs& runs, const RobotModel& robot, const PhysicsProfile& physics) {
  int agree = 0;
  for (const auto& [name, run] : runs) {
    const Comparison result = compare(run, driven(run, robot, physics));
    UNSCOPED_INFO(physics.name << ' ' << name << ": off " << 1e3 * result.off << " mm of "
                               << 1e3 * result.allowed << ", yaw " << result.yaw
                               << (result.agrees() ? "" : " *"));
    agree += result.agrees() ? 1 : 0;
  }
  return agree;
}

}  // namespace fulbito::test
