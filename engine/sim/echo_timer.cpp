#include <algorithm>
#include <cmath>

#include "fulbito/sensors.hpp"

namespace fulbito {
namespace {

constexpr double kMeltingIce = 273.15;     // [K]
constexpr double kSoundAtMelting = 331.3;  // [m/s] in dry air

}  // namespace

double speedOfSound(double celsius) {
  return kSoundAtMelting * std::sqrt(std::max(0.0, 1.0 + celsius / kMeltingIce));
}

std::int64_t EchoTimer::microseconds(double range) const {
  return static_cast<std::int64_t>(std::floor(std::max(0.0, range) * per_metre_ + 0.5));
}

}  // namespace fulbito
