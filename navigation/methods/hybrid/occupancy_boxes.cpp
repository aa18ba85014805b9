#include "navigation/methods/hybrid/occupancy_boxes.hpp"

#include <array>
#include <cmath>

namespace fulbito {
namespace {

/// The boxes of one side with the nearest echo of each.
class BoxRow {
 public:
  void add(int box, Vec2 echo) {
    std::optional<Vec2>& kept = echoes_[static_cast<std::size_t>(box)];
    if (!kept || echo.x < kept->x) kept = echo;
  }
  /// The echo of the occupied box nearest the x axis.
  std::optional<Vec2> nearest() const {
    for (const auto& echo : echoes_)
      if (echo) return echo;
    return {};
  }
  std::optional<Vec2> farthest() const {
    std::optional<Vec2> last;
    for (const auto& echo : echoes_)
      if (echo) last = echo;
    return last;
  }

 private:
  std::array<std::optional<Vec2>, kMostBoxes> echoes_;
};

}  // namespace

std::optional<FrontSection> frontSection(std::span<const Vec2> echoes, const OccupancyBoxes& boxes) {
  BoxRow left, right;
  for (Vec2 echo : echoes) {
    if (!(echo.x > 0.0 && echo.x <= boxes.length && std::abs(echo.y) < boxes.width * boxes.per_side))
      continue;
    (echo.y >= 0.0 ? left : right).add(static_cast<int>(std::abs(echo.y) / boxes.width), echo);
  }
  if (left.nearest() && right.nearest()) return FrontSection{*left.farthest(), *right.farthest()};
  const BoxRow& side = left.nearest() ? left : right;
  if (!side.nearest()) return {};
  return FrontSection{*side.nearest(), *side.farthest()};
}

}  // namespace fulbito
