#include "navigation/methods/hybrid/side_balance.hpp"

#include <algorithm>
#include <limits>

namespace fulbito {
namespace {

constexpr double kShare = 0.15;  // of a new difference in the smoothed one

double nearestOf(std::span<const RangeReading> readings) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const RangeReading& reading : readings) {
    if (reading.heard) nearest = std::min(nearest, reading.range);
  }
  return nearest;
}

}  // namespace

void SideBalance::update(std::span<const RangeReading> readings, double beside) {
  const std::size_t half = readings.size() / 2;
  const double left = nearestOf(readings.first(half)), right = nearestOf(readings.subspan(half));
  if (left < beside && right < beside) {
    const double difference = (left - right) / 2;
    offset_ = silent_ < kForgotten ? offset_ + kShare * (difference - offset_) : difference;
    silent_ = 0;
  } else if (silent_ < kForgotten) {
    ++silent_;
  }
}

}  // namespace fulbito
