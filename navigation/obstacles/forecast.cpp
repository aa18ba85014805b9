#include "navigation/obstacles/forecast.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kMoving = 0.03;      // [m/s]
constexpr double kLook = 1.0 / 60.0;  // [s]
constexpr double kMostHorizon = 2.0;  // [s]

}  // namespace

bool forecast(const NavigationScene& scene, std::vector<ForecastDisc>& out) {
  bool any_moves = false;
  out.clear();
  for (const DiscObstacle& o : scene.obstacles) {
    ForecastDisc disc;
    disc.position = o.position;
    disc.velocity = o.velocity;
    disc.radius = o.radius;
    disc.moves = squaredNorm(o.velocity) > kMoving * kMoving;
    // A disc in a goal or partly in a wall keeps at least its present room.
    disc.room = {std::max(scene.field->length / 2 - o.radius, std::abs(o.position.x)),
                 std::max(scene.field->width / 2 - o.radius, std::abs(o.position.y))};
    any_moves = any_moves || disc.moves;
    out.push_back(disc);
  }
  return any_moves;
}

bool meetsWithin(const BodyShape& body, Vec2 position, Vec2 along, Vec2 velocity, const ForecastDisc& disc,
                 double horizon) {
  const double reach = disc.radius + body.half_length + body.half_width +
                       horizon * std::sqrt(squaredNorm(velocity - disc.velocity));
  if (squaredNorm(disc.position - position) > reach * reach) return false;
  const int looks = 1 + static_cast<int>(std::min(horizon, kMostHorizon) / kLook);
  for (int look = 1; look <= looks; ++look) {
    const double time = kLook * look;
    if (discClearance(body, position + velocity * time, along, disc.at(time), disc.radius) < 0.0) return true;
  }
  return false;
}

}  // namespace fulbito
