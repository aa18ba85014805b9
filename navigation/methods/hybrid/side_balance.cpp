#include "navigation/methods/hybrid/side_balance.hpp"

namespace fulbito {
namespace {

constexpr double kShare = 0.15;  // of a new difference in the smoothed one

}  // namespace

void SideBalance::update(std::span<const RangeReading> readings, double beside) {
  double least = 2.0 * beside, difference = 0.0;
  for (std::size_t i = 0; i < readings.size() / 2; ++i) {
    const RangeReading &left = readings[i], &right = readings[readings.size() - 1 - i];
    const bool both = left.heard && right.heard && left.range < beside && right.range < beside;
    if (both && left.range + right.range < least) {
      least = left.range + right.range;
      difference = (left.range - right.range) / 2;
    }
  }
  if (least < 2.0 * beside) {
    offset_ = silent_ < kForgotten ? offset_ + kShare * (difference - offset_) : difference;
    silent_ = 0;
  } else if (silent_ < kForgotten) {
    ++silent_;
  }
}

}  // namespace fulbito
