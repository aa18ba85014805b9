#include "tournament/statistics/normal.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {

double normalShareBelow(double z) {
  constexpr double kB[] = {0.319381530, -0.356563782, 1.781477937, -1.821255978, 1.330274429};
  const double t = 1.0 / (1.0 + 0.2316419 * std::abs(z));
  double sum = 0.0;
  for (int i = 4; i >= 0; --i) sum = (sum + kB[i]) * t;
  const double beyond = math::exp(-z * z / 2) / std::sqrt(2.0 * math::kPi) * sum;
  return z >= 0.0 ? 1.0 - beyond : beyond;
}

}  // namespace fulbito
