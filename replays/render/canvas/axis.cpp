#include "replays/render/canvas/axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr double kSmallest = 1e-9, kLargest = 1e9;  // range in which plain decimals are readable

}  // namespace

int Axis::steps() const { return static_cast<int>(std::round((high - low) / step)); }

std::string Axis::text(double value, int more) const {
  if (std::abs(value) > kLargest) return fmt::format("{:.3g}", value);
  // Removes the sign of a negative zero.
  const std::string text = fmt::format("{:.{}f}", value, decimals + more);
  return text.find_first_not_of("-0.") == std::string::npos && text[0] == '-' ? text.substr(1) : text;
}

Axis niceAxis(double low, double high) {
  if (!(high > low)) return {};
  low = std::max(low, -kLargest), high = std::min(high, kLargest);
  const double span = std::max(high - low, kSmallest);
  double power = 1.0;
  int decimals = 0;
  while (power > span / 4) power /= 10, ++decimals;
  while (power * 10 <= span / 4) power *= 10, --decimals;
  const double share = span / 4 / power;  // 1 ... 10
  Axis axis;
  axis.step = power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
  axis.decimals = std::max(decimals, 0);
  axis.low = std::floor(low / axis.step) * axis.step;
  axis.high = std::ceil(high / axis.step) * axis.step;
  return axis;
}

}  // namespace fulbito
