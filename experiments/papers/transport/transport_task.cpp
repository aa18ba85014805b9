#include "experiments/papers/transport/transport_task.hpp"

#include <algorithm>

namespace fulbito {

Result<double> rodLengthAhead(const PartPath& path, double from, double rod) {
  constexpr double kStride = 0.002;  // [m]
  const Vec2 first = path.pose(from).position;
  const auto excess = [&](double q) { return distance(path.pose(q).position, first) - rod; };
  double low = from, high = from;
  while (excess(high) < 0.0) {
    if (high >= path.length())
      return fail(ErrorCode::kBadInput, "no point of the path is a rod's length away from the follower");
    low = high;
    high = std::min(high + kStride, path.length());
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace fulbito
