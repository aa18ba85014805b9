#include "strategies/prediction/ball_walls.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

/// Distance [m] of a point from the straight line between `from` and `to`, exact to the line's shortest
/// length.
double distanceToStretch(Vec2 point, Vec2 from, Vec2 to) {
  constexpr double kShortest = 1e-6;  // [m]
  const Vec2 way = to - from;
  const double share = dot(point - from, way) / std::max(squaredNorm(way), kShortest * kShortest);
  return distance(point, from + way * std::clamp(share, 0.0, 1.0));
}

}  // namespace

std::optional<double> timeOfFall(double height, double speed, double acceleration, double duration) {
  constexpr double kSlowest = 1e-6;  // [m/s] smaller speeds are rounding errors
  if (height <= 0.0 && speed < -kSlowest) return 0.0;
  if (height < 0.0) return std::nullopt;
  const double discriminant = speed * speed - 2.0 * acceleration * height;
  if (discriminant < 0.0) return std::nullopt;
  // The root at which the height falls, in the form without cancellation.
  const double falling = std::sqrt(discriminant);
  if (falling <= kSlowest) return std::nullopt;
  double time;
  if (speed <= 0.0) {
    time = 2.0 * height / (falling - speed);
  } else {
    if (acceleration >= 0.0) return std::nullopt;
    time = (-falling - speed) / acceleration;
  }
  if (!(time >= 0.0 && time <= duration)) return std::nullopt;
  return time;
}

BallWalls::BallWalls(const FieldGeometry& field, double radius) : radius_(radius) {
  half_length_ = field.length / 2 - radius;
  half_width_ = field.width / 2 - radius;
  half_diagonal_ = field.length / 2 + field.width / 2 - field.corner - radius * std::sqrt(2.0);
  const std::vector<Vec2> contour = innerContour(field);
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Vec2 a = contour[i], b = contour[(i + 1) % contour.size()];
    const Vec2 after = contour[(i + 2) % contour.size()] - b;
    const Vec2 along = unitOr(b - a, {1.0, 0.0}), normal = perp(along);
    lines_.push_back({a + normal * radius, normal, distance(a, b)});
    if (cross(along, after) < 0.0) posts_.push_back(b);
  }
}

bool BallWalls::isFree(Vec2 p, double margin) const {
  const double x = std::abs(p.x) + margin, y = std::abs(p.y) + margin;
  return x < half_length_ && y < half_width_ && std::abs(p.x) + std::abs(p.y) + 1.5 * margin < half_diagonal_;
}

std::optional<BallWalls::Hit> BallWalls::firstHit(const EvenMotion& motion, double duration) const {
  // A parabola is at most `bulge` away from its chord. At a share s of the way from an end of the chord, it
  // is at most 4 s `bulge` away. So the path keeps clear of a wall if its start is free and its end is 4
  // `bulge` off that wall.
  const double bulge = norm(motion.acceleration) * duration * duration / 8.0;
  const Vec2 end = motion.positionAt(duration);
  if (isFree(motion.position) && isFree(end, 4.0 * bulge)) return std::nullopt;
  // The rectangle with cut corners is convex.
  if (isFree(motion.position, bulge) && isFree(end, bulge)) return std::nullopt;
  std::optional<Hit> first;
  double until = duration;
  for (const Line& line : lines_) {
    constexpr double kDeepest = 0.01;  // [m] a ball deeper behind this wall is on another wall's side
    const double height = dot(motion.position - line.begin, line.normal);
    if (height >= -kDeepest && dot(end - line.begin, line.normal) <= 4.0 * bulge)
      meetLine(line, height, motion, first, until);
  }
  // All of the path lies in a circle around the middle of its chord, and within its bulge of the chord.
  const Vec2 stop = motion.positionAt(until);
  const double near = radius_ + norm(motion.acceleration) * until * until / 8.0;
  const double reach = near + distance(motion.position, stop) / 2.0;
  for (const Vec2 post : posts_) {
    constexpr double kSure = 1e-4;  // [m] more than `meetPost` allows a touching ball
    if (squaredNorm((motion.position + stop) / 2.0 - post) <= reach * reach &&
        distanceToStretch(post, motion.position, stop) <= near + kSure)
      meetPost(post, motion, first, until);
  }
  return first;
}

void BallWalls::meetLine(const Line& line, double height, const EvenMotion& motion, std::optional<Hit>& first,
                         double& until) const {
  const auto time =
      timeOfFall(height, dot(motion.velocity, line.normal), dot(motion.acceleration, line.normal), until);
  if (!time || (first && *time >= until)) return;
  const double along = cross(line.normal, line.begin - motion.positionAt(*time));
  if (along < 0.0 || along > line.length) return;
  first = Hit{*time, line.normal};
  until = *time;
}

void BallWalls::meetPost(Vec2 post, const EvenMotion& motion, std::optional<Hit>& first,
                         double& until) const {
  constexpr double kTouch = 1e-5;  // [m]
  constexpr double kStep = 1e-4;   // [m] least motion between two looks of a ball that leaves the post
  constexpr int kMostLooks = 200;
  // The speed is greatest at an end of the motion. At that speed the ball needs at least the time below to
  // close the gap.
  const double fastest = std::max(norm(motion.velocity), norm(motion.velocityAt(until)));
  if (fastest <= 0.0) return;
  double time = 0.0;
  for (int look = 0; look < kMostLooks && time < until; ++look) {
    const Vec2 from = motion.positionAt(time) - post;
    const double gap = norm(from) - radius_;
    const bool approaches = dot(from, motion.velocityAt(time)) < 0.0;
    if (gap <= kTouch && approaches) {
      first = Hit{time, unitOr(from, {1.0, 0.0})};
      until = time;
      return;
    }
    // Its way from here, v t + a t^2 / 2, never leads back toward the post, so the gap stays at least as
    // wide.
    const Vec2 way = motion.velocityAt(time) + motion.acceleration * ((until - time) / 2.0);
    if (!approaches && gap > 2.0 * kTouch && dot(from, way) >= 0.0) return;
    time += std::max(gap, approaches ? kTouch : kStep) / fastest;
  }
}

}  // namespace fulbito
