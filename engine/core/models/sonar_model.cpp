#include "engine/core/models/sonar_model.hpp"

#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kFarthest = 20.0;    // [m] the largest field
constexpr double kMostNoise = 1.0;    // [m]
constexpr double kWidestCone = 1.57;  // [rad] a cone, not a half plane

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

}  // namespace

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
