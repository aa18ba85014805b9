#include "navigation/methods/hybrid/avoidance_table.hpp"

#include <algorithm>
#include <array>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = math::kPi / 180.0;
constexpr double kOutermost = 10.0;  // [deg] instead of the printed 0
constexpr std::array<double, kTableSonars> kTable{-kOutermost, -30.0, -50.0, -80.0,
                                                  80.0,        50.0,  30.0,  kOutermost};
constexpr double kOpposite = 0.1;  // of K: shorter sums of two opposite directions are none

}  // namespace

std::optional<double> avoidanceDirection(std::span<const double, kTableSonars> readings, double goal_bearing,
                                         const AvoidanceRanges& ranges) {
  const auto least = std::min_element(readings.begin(), readings.end());
  const auto sonar = static_cast<std::size_t>(least - readings.begin());
  const bool outermost = sonar == 0 || sonar + 1 == kTableSonars;
  const double away = ranges.as_printed && outermost ? 0.0 : kTable[sonar] * kDegree;
  if (*least <= ranges.near) {
    const double alpha =
        ((ranges.as_printed ? ranges.far : ranges.near) - *least) * (90.0 * kDegree / ranges.near);
    return math::wrapAngle(sonar < kTableSonars / 2 ? away - alpha : away + alpha);
  }
  if (*least > ranges.far) return {};
  const Vec2 sum = math::unit(away) + math::unit(goal_bearing);
  return norm(sum) < kOpposite ? away : math::angleOf(sum);
}

}  // namespace fulbito
