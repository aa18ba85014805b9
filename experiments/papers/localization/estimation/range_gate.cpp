#include "experiments/papers/localization/estimation/range_gate.hpp"

#include <cmath>

namespace fulbito::localization {

bool RangeGate::agrees(const Reading& now, const Reading& before, Vec2 direction) const {
  if (!now.range || !before.range) return false;
  const double nearer = dot(now.sensor - before.sensor, direction);
  return std::abs(*now.range - *before.range + nearer) <= limit_;
}

bool RangeGate::accept(std::optional<double> range, Vec2 sensor, Vec2 direction) {
  const Reading now{range, sensor};
  const bool accepted = agrees(now, before_[0], direction) && agrees(now, before_[1], direction);
  before_ = {now, before_[0]};
  return accepted;
}

}  // namespace fulbito::localization
