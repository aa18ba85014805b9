#include "engine/core/base/match_clock.hpp"

#include <cmath>

#include <fmt/format.h>

namespace fulbito {

std::string clockText(double seconds) {
  // Times are multiples of the tick: a value just below a tenth is that tenth with a rounding error.
  const double tenths = std::floor(seconds * 10 + 1e-6);
  const auto count = static_cast<long long>(tenths > 0.0 ? std::fmin(tenths, 1e9) : 0.0);
  return fmt::format("{}:{:02}.{}", count / 600, count / 10 % 60, count % 10);
}

std::string periodName(int period) {
  switch (period) {
    case 1:
      return "1st half";
    case 2:
      return "2nd half";
    case 3:
      return "overtime";
    case 4:
      return "shoot-out";
    default:
      return fmt::format("period {}", period);
  }
}

}  // namespace fulbito
