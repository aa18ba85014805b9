#include "navigation/forecast.hpp"

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
    // A disc in a goal or half in a wall keeps at least the room that it has.
    disc.room = {std::max(scene.field->length / 2 - o.radius, std::abs(o.position.x)),
                 std::max(scene.field->width / 2 - o.radius, std::abs(o.position.y))};
    any_moves = any_moves || disc.moves;
    out.push_back(disc);
  }
  return any_moves;
}

BodyShape bodyShape(const RobotModel& robot) { return {robot.length / 2, robot.width / 2}; }

double discClearance(const BodyShape& body, Vec2 position, Vec2 along, Vec2 centre, double radius) {
  const Vec2 d = centre - position;
  const double x = std::abs(dot(d, along)) - body.half_length;
  const double y = std::abs(cross(along, d)) - body.half_width;
  if (x > 0.0 && y > 0.0) return std::sqrt(x * x + y * y) - radius;
  return std::max(x, y) - radius;
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

double wallClearance(const BodyShape& body, Vec2 position, Vec2 along, const FieldGeometry& field) {
  const double x = std::abs(position.x), y = std::abs(position.y);
  const double tx = std::abs(along.x), ty = std::abs(along.y);
  const double to_end = field.length / 2 - x - body.half_length * tx - body.half_width * ty;
  const double to_side = field.width / 2 - y - body.half_length * ty - body.half_width * tx;
  const double least = std::min(to_end, to_side);
  if (field.corner <= 0.0) return least;
  const double half_root = 0.70710678118654752;
  // The corner's face has the normal (1, 1) in the quadrant of the position.
  const double same = position.x * position.y * along.x * along.y >= 0.0 ? 1.0 : -1.0;
  const double ahead = std::abs(tx + same * ty), across = std::abs(tx - same * ty);
  const double to_corner = half_root * (field.length / 2 + field.width / 2 - field.corner - x - y -
                                        body.half_length * ahead - body.half_width * across);
  return std::min(least, to_corner);
}

}  // namespace fulbito
