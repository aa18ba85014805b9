#include <algorithm>

#include <fmt/format.h>

#include "fulbito/models.hpp"

namespace fulbito {
namespace {

Result<void> inRange(const char* name, double value, double most, const char* unit) {
  if (value >= 0.0 && value <= most) return {};
  return fail(ErrorCode::kUsage, fmt::format("{}: {} is outside 0 ... {:.4g}{}", name, value, most, unit));
}

}  // namespace

double headingNoise(double position_noise, double body_length) {
  return std::min(2.0 * position_noise / body_length, kMaxHeadingNoise);
}

Result<void> validate(const SensorModel& sensors) {
  for (const auto& checked : {inRange("latency", sensors.latency_ticks, kMaxLatencyTicks, " ticks"),
                              inRange("noise", sensors.position_noise, kMaxPositionNoise, " m"),
                              inRange("heading noise", sensors.heading_noise, kMaxHeadingNoise, " rad"),
                              inRange("dropout", sensors.dropout, kMaxDropout, "")}) {
    if (!checked) return checked;
  }
  return {};
}

}  // namespace fulbito
