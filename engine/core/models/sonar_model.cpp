#include "fulbito/detail/sonar_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kFarthest = 20.0;    // [m] the largest field
constexpr double kMostNoise = 1.0;    // [m]
constexpr double kWidestCone = 1.57;  // [rad] just below pi / 2: a half plane is no cone

Result<void> inRange(const std::string& name, double value, double least, double most, const char* unit) {
  if (value >= least && value <= most) return {};
  return fail(ErrorCode::kUsage,
              fmt::format("{}: {} is outside {:.4g} ... {:.4g}{}", name, value, least, most, unit));
}

Result<void> validate(const SonarSpec& sonar, std::size_t number) {
  const std::string name = fmt::format("sonar {}: ", number);
  for (const auto& checked : {inRange(name + "x", sonar.mount.position.x, -kFarthest, kFarthest, " m"),
                              inRange(name + "y", sonar.mount.position.y, -kFarthest, kFarthest, " m"),
                              inRange(name + "bearing", sonar.mount.heading, -math::kPi, math::kPi, " rad"),
                              inRange(name + "half cone", sonar.half_cone, 0.0, kWidestCone, " rad"),
                              inRange(name + "greatest range", sonar.greatest, 0.0, kFarthest, " m"),
                              inRange(name + "least range", sonar.least, 0.0, sonar.greatest, " m")}) {
    if (!checked) return checked;
  }
  return {};
}

/// From the body's centre to its outline along a unit vector of the robot's frame.
double outlineReach(const RobotModel& robot, Vec2 way) {
  const double x = std::abs(way.x), y = std::abs(way.y);
  return x * robot.width > y * robot.length ? robot.length / 2 / x : robot.width / 2 / y;
}

}  // namespace

double pioneerScale(const RobotModel& robot) { return robot.circumradius() / kPioneerRadius; }

std::vector<SonarSpec> frontSonars(const RobotModel& robot) {
  constexpr double kDegree = math::kPi / 180.0, kReach = 1.5;  // [m] d_max of the paper
  std::vector<SonarSpec> sonars;
  for (double bearing : {90.0, 50.0, 30.0, 10.0, -10.0, -30.0, -50.0, -90.0}) {
    SonarSpec sonar;
    const Vec2 way = math::unit(bearing * kDegree);
    sonar.mount = {way * outlineReach(robot, way), bearing * kDegree};
    sonar.half_cone = 12.5 * kDegree;
    sonar.greatest = kReach * pioneerScale(robot);
    sonars.push_back(sonar);
  }
  return sonars;
}

Result<void> validate(const SonarModel& model) {
  for (std::size_t i = 0; i < model.sonars.size(); ++i) {
    if (auto checked = validate(model.sonars[i], i); !checked) return checked;
  }
  for (const auto& checked :
       {inRange("noise", model.noise, 0.0, kMostNoise, " m"), inRange("dropout", model.dropout, 0.0, 1.0, ""),
        inRange("specular limit", model.specular_limit, 0.0, math::kPi / 2, " rad"),
        inRange("cross-talk", model.cross_talk, 0.0, 1.0, "")}) {
    if (!checked) return checked;
  }
  return {};
}

}  // namespace fulbito
