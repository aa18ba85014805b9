#include "navigation/methods/bspline/spline_optimiser.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kLeastStep = 0.0008;  // [m] a direction with a smaller step has converged
constexpr double kMostStep = 0.08;     // [m]
constexpr double kGrow = 1.6;
constexpr double kShrink = 0.45;

}  // namespace

void SplineOptimiser::start(const CubicSpline& seed, std::size_t fixed_front, std::size_t fixed_back,
                            double step) {
  best_ = seed;
  score_ = {};
  scored_ = false;
  const std::size_t n = seed.controls();
  first_ = std::min(fixed_front, n);
  end_ = n > fixed_back ? n - fixed_back : 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 along = seed.control(std::min(i + 1, n - 1)) - seed.control(i > 0 ? i - 1 : 0);
    across_[i] = perp(unitOr(along, {1.0, 0.0}));
  }
  directions_.fill({step, false});
  turn_ = 0;
}

void SplineOptimiser::freezeBefore(std::size_t index) { first_ = std::max(first_, index); }

bool SplineOptimiser::live(std::size_t direction) const {
  const std::size_t centre = direction / kWidths;
  return centre >= first_ && centre < end_ && std::abs(directions_[direction].step) >= kLeastStep;
}

bool SplineOptimiser::converged() const {
  if (!scored_) return false;
  for (std::size_t d = 0; d < kWidths * best_.controls(); ++d) {
    if (live(d)) return false;
  }
  return true;
}

CubicSpline SplineOptimiser::moved(std::size_t direction, double by) const {
  CubicSpline spline = best_;
  const std::size_t centre = direction / kWidths, width = 2 * (direction % kWidths);
  // Moves of single control points make bends that are slow to drive. Wide bumps move whole stretches.
  const std::size_t begin = std::max(first_, centre - std::min(centre, width));
  const std::size_t end = std::min(end_, centre + width + 1);
  for (std::size_t i = begin; i < end; ++i) {
    const double off = static_cast<double>(i > centre ? i - centre : centre - i);
    const double share = 1.0 - off / static_cast<double>(width + 1);
    spline.set(i, best_.control(i) + across_[i] * (by * share));
  }
  return spline;
}

void SplineOptimiser::learn(Direction& direction, bool better) {
  if (better) {
    direction.step = std::clamp(direction.step * kGrow, -kMostStep, kMostStep);
    direction.reversed = false;
  } else if (!direction.reversed) {
    direction.step = -direction.step;
    direction.reversed = true;
    return;  // the next move tries the opposite way
  } else {
    direction.step *= kShrink;
    direction.reversed = false;
  }
  next();
}

void SplineOptimiser::next() {
  const std::size_t all = kWidths * best_.controls();
  for (std::size_t tried = 0; tried < all; ++tried) {
    turn_ = turn_ + 1 < all ? turn_ + 1 : 0;
    if (live(turn_)) return;
  }
}

int SplineOptimiser::improve(SplineCost& cost, int evaluations) {
  int used = 0;
  if (!scored_ && evaluations > 0) {
    score_ = cost(best_);
    scored_ = true;
    ++used;
  }
  if (best_.controls() == 0) return used;
  if (!live(turn_)) next();
  while (used < evaluations && live(turn_)) {
    const CubicSpline candidate = moved(turn_, directions_[turn_].step);
    const SplineScore score = cost(candidate, score_.cost);
    ++used;
    const bool better = score.cost < score_.cost;
    if (better) best_ = candidate, score_ = score;
    learn(directions_[turn_], better);
  }
  return used;
}

}  // namespace fulbito
