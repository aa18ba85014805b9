#include "navigation/obstacles/arc_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/wall_lines.hpp"

namespace fulbito {
namespace {

constexpr double kSliver = 1e-4;  // [m] least motion that a touching robot may make
constexpr double kFar = 1e6;      // [m] or [m/s]; limit that keeps squares finite
constexpr std::size_t kReserve = 64;

/// Share [0, 1] of a relative move at which a point at `from` enters the circle about the origin; > 1 if it
/// does not.
double entry(Vec2 from, Vec2 move, double radius) {
  const double square = squaredNorm(move), approach = dot(from, move);
  const double outside = squaredNorm(from) - radius * radius;
  if (outside <= 0.0) return approach < 0.0 ? 0.0 : 2.0;
  if (approach >= 0.0) return 2.0;
  const double root = approach * approach - square * outside;
  return root < 0.0 ? 2.0 : (-approach - std::sqrt(root)) / square;
}

}  // namespace

ArcSweep::ArcSweep(double horizon, int chords) : horizon_(horizon), chords_(chords) {
  discs_.reserve(kReserve);
  walls_.reserve(8);
}

void ArcSweep::look(const NavigationScene& scene, double margin, double top_speed) {
  discs_.clear();
  walls_.clear();
  const Pose2& pose = scene.self.pose;
  const Vec2 ux = math::unit(pose.heading);
  const double radius = scene.robot->circumradius() + margin;
  for (const DiscObstacle& obstacle : scene.obstacles) {
    addDisc(intoFrame(ux, obstacle.position - pose.position), intoFrame(ux, obstacle.velocity),
            obstacle.radius + radius, top_speed);
  }
  addWalls(*scene.field, pose, radius, top_speed);
}

void ArcSweep::addDisc(Vec2 centre, Vec2 velocity, double radius, double top_speed) {
  const double range = norm(centre), speed = norm(velocity);
  if (!(range < kFar && speed < kFar) || range - radius > (top_speed + speed) * horizon_) return;
  discs_.push_back({centre, velocity, std::max(0.0, std::min(radius, range - kSliver))});
}

void ArcSweep::addWalls(const FieldGeometry& field, const Pose2& pose, double radius, double top_speed) {
  for (const WallLine& wall : wallLines(field, pose)) {
    const double room = wall.clearance - radius;
    if (room <= top_speed * horizon_) walls_.push_back({wall.outward, std::max(room, kSliver)});
  }
}

double ArcSweep::contactOnChord(Vec2 from, Vec2 move, int chord) const {
  const double step = horizon_ / chords_;
  double share = 2.0;
  for (const Disc& disc : discs_) {
    const Vec2 centre = disc.centre + disc.velocity * (step * chord);
    share = std::min(share, entry(from - centre, move - disc.velocity * step, disc.radius));
  }
  for (const Wall& wall : walls_) {
    const double left = wall.room - dot(wall.outward, from), gain = dot(wall.outward, move);
    if (gain > left) share = std::min(share, std::max(0.0, left / gain));
  }
  return share;
}

double ArcSweep::freeTime(const RampedArc& arc) const {
  const double step = horizon_ / chords_;
  const int ramp = static_cast<int>(std::clamp(std::round(arc.ramp_time / step), 0.0, 1.0 * chords_));
  Vec2 at{}, along{1.0, 0.0};
  for (int chord = 0; chord < chords_;) {
    const bool ramping = chord < ramp;
    const int end = ramping ? ramp : chords_;
    const Twist twist = ramping ? arc.ramp : arc.cruise;
    const Vec2 first = poseOnArc(twist, step).position;
    const Vec2 turn = math::unit(twist.angular * step);
    for (; chord < end; ++chord) {
      const Vec2 move = outOfFrame(along, first);
      const double share = contactOnChord(at, move, chord);
      if (share <= 1.0) return (chord + share) * step;
      at += move;
      along = outOfFrame(along, turn);
    }
  }
  return horizon_;
}

Pose2 RampedArc::poseAt(double time) const {
  const Pose2 first = poseOnArc(ramp, std::min(time, ramp_time));
  if (time <= ramp_time) return first;
  const Pose2 second = poseOnArc(cruise, time - ramp_time);
  const Vec2 ux = math::unit(first.heading);
  return {first.position + outOfFrame(ux, second.position), math::wrapAngle(first.heading + second.heading)};
}

double RampedArc::lengthAt(double time) const {
  return std::abs(ramp.linear) * std::min(time, ramp_time) +
         std::abs(cruise.linear) * std::max(0.0, time - ramp_time);
}

Pose2 poseOnArc(Twist twist, double time) {
  const double half = twist.angular * time / 2;
  const math::SinCos sc = math::sinCos(half);
  // The chord is the arc times sin(half) / half, in the direction of half the turn.
  const double ratio = std::abs(half) > 1e-6 ? sc.sin / half : 1.0;
  const double chord = twist.linear * time * ratio;
  return {{chord * sc.cos, chord * sc.sin}, math::wrapAngle(2.0 * half)};
}

}  // namespace fulbito
