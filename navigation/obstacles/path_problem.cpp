#include "navigation/obstacles/path_problem.hpp"

#include <algorithm>
#include <cmath>

#include "navigation/geometry/polyline.hpp"

namespace fulbito {
namespace {

constexpr double kTouch = 1e-9;       // [m]
constexpr double kEndReach = 0.10;    // [m] around an end with a margin of its own
constexpr double kGiveWay = 0.01;     // [m] of clearance given up for an end with too little clearance
constexpr double kPlanShare = 0.8;    // average speed of a robot as a share of its top speed
constexpr double kRestSpeed = 0.005;  // [m/s] slower obstacles count as resting

}  // namespace

bool isMoving(const DiscObstacle& obstacle) {
  return squaredNorm(obstacle.velocity) > kRestSpeed * kRestSpeed;
}

double meetingTime(const DiscObstacle& obstacle, Vec2 robot, double speed, double horizon) {
  // |d + v t| = speed t; its smaller positive root, in the form without cancellation.
  const Vec2 d = obstacle.position - robot;
  const double along = dot(d, obstacle.velocity), square = squaredNorm(d);
  const double root = along * along + (speed * speed - squaredNorm(obstacle.velocity)) * square;
  const double closing = root >= 0.0 ? std::sqrt(root) - along : 0.0;
  return closing > 0.0 ? std::min(horizon, square / closing) : horizon;
}

void predictObstacles(const NavigationScene& scene, double horizon, std::vector<Circle>& out) {
  out.clear();
  const double speed = kPlanShare * scene.robot->maxSpeed();
  for (const DiscObstacle& o : scene.obstacles) {
    const double time = isMoving(o) ? meetingTime(o, scene.self.pose.position, speed, horizon) : 0.0;
    out.push_back({o.position + o.velocity * time, o.radius});
  }
}

void PathGuard::prepare(Vec2 start, Vec2 goal, std::span<const Circle> bodies, double robot_radius,
                        double clearance, const FieldGeometry& field) {
  start_ = start;
  goal_ = goal;
  field_ = &field;
  wall_margin_ = robot_radius;
  start_margin_ = std::min(wall_margin_, wallClearance(field, start)) - kTouch;
  goal_margin_ = std::min(wall_margin_, wallClearance(field, goal)) - kTouch;
  discs_.clear();
  for (const Circle& body : bodies) {
    const double room = std::min(distance(body.centre, start), distance(body.centre, goal)) - kTouch;
    const double hard = body.radius + robot_radius;
    double radius = hard + clearance;
    if (room < radius) radius = std::min(room, std::max(hard, room - kGiveWay));
    discs_.push_back({body.centre, std::max(0.0, radius)});
  }
}

double PathGuard::margin(Vec2 p) const {
  double margin = wall_margin_;
  if (squaredNorm(p - start_) < kEndReach * kEndReach) margin = std::min(margin, start_margin_);
  if (squaredNorm(p - goal_) < kEndReach * kEndReach) margin = std::min(margin, goal_margin_);
  return margin;
}

bool PathGuard::insideWalls(std::span<const Vec2> points) const {
  return std::all_of(points.begin(), points.end(),
                     [this](Vec2 p) { return wallClearance(*field_, p) >= margin(p); });
}

bool PathGuard::clearAt(Vec2 p) const {
  return std::none_of(discs_.begin(), discs_.end(), [p](const Circle& disc) {
    return squaredNorm(p - disc.centre) < disc.radius * disc.radius;
  });
}

bool PathGuard::clear(std::span<const Vec2> path) const {
  for (const Circle& disc : discs_) {
    const double square = disc.radius * disc.radius;
    // Checks of points cost less than checks of segments and find most blocked paths.
    for (Vec2 p : path) {
      if (squaredNorm(p - disc.centre) < square) return false;
    }
  }
  for (const Circle& disc : discs_) {
    const double square = disc.radius * disc.radius;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (squaredDistanceToSegment(path[i - 1], path[i], disc.centre) < square) return false;
    }
  }
  return true;
}

}  // namespace fulbito
