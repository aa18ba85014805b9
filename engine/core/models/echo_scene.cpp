#include "fulbito/detail/echo_scene.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kShortestFace = 1e-3;  // [m] shorter faces are merged
constexpr double kSame = 1e-7;          // [m] a surface nearer than a point by more than this hides it
// [cosine] tolerance for corners of 90 degrees, which still reflect sound
constexpr double kRightAngle = 1e-6;
constexpr double kSteepest = 1.57;            // [rad] just below pi / 2, where the tangent is infinite
constexpr double kRayStep = math::kPi / 180;  // [rad] between rays at partly hidden surfaces

double signedAngle(Vec2 from, Vec2 to) { return math::atan2(cross(from, to), dot(from, to)); }

}  // namespace

void EchoScene::clear() {
  faces_.clear();
  corners_.clear();
  discs_.clear();
}

void EchoScene::addDisc(Vec2 centre, double radius) { discs_.push_back({centre, radius}); }

void EchoScene::addOutline(std::span<const Vec2> points, double free_side) {
  distinct_.clear();
  for (Vec2 p : points) {
    if (distinct_.empty() || distance(distinct_.back(), p) >= kShortestFace) distinct_.push_back(p);
  }
  while (distinct_.size() > 1 && distance(distinct_.front(), distinct_.back()) < kShortestFace)
    distinct_.pop_back();
  const std::size_t count = distinct_.size(), first = faces_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 from = distinct_[i], to = distinct_[(i + 1) % count];
    faces_.push_back({from, to, perp(unitOr(to - from, {})) * free_side});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 before = faces_[first + (i + count - 1) % count].normal, after = faces_[first + i].normal;
    const bool hollow = cross(before, after) * free_side > 0.0;
    const bool turns_left = cross(before, after) > 0.0;
    corners_.push_back({distinct_[i], turns_left ? before : after, turns_left ? after : before, hollow});
  }
}

RayHit EchoScene::castRay(Vec2 from, Vec2 direction, double range) const {
  RayHit hit;
  const auto keep = [&](double far, Vec2 normal) {
    if (far <= range && far < hit.distance) hit = {far, normal};
  };
  for (const Face& face : faces_) {
    const double height = dot(from - face.from, face.normal), sinking = -dot(direction, face.normal);
    if (height < 0.0 || sinking <= 0.0 || height > range * sinking) continue;
    const double far = height / sinking;
    const Vec2 point = from + direction * far;
    if (dot(point - face.from, face.to - face.from) >= 0.0 &&
        dot(point - face.to, face.from - face.to) >= 0.0)
      keep(far, face.normal);
  }
  for (const Disc& disc : discs_) {
    const Vec2 centre = disc.centre - from;
    const double along = dot(centre, direction), across = cross(direction, centre);
    const double chord = disc.radius * disc.radius - across * across;
    if (squaredNorm(centre) <= disc.radius * disc.radius) keep(0.0, -direction);
    if (along <= 0.0 || chord < 0.0) continue;
    const double far = std::max(0.0, along - std::sqrt(chord));
    keep(far, unitOr(direction * far - centre, -direction));
  }
  return hit;
}

/// Collects the nearest echo of one cone.
class EchoScene::Listener {
 public:
  Listener(const EchoScene& scene, const Cone& cone, double limit)
      : scene_(scene), cone_(cone), limit_(limit), cos_limit_(math::cos(limit)) {}

  Echo listen() {
    for (const Face& face : scene_.faces_) hear(face);
    for (const Disc& disc : scene_.discs_) hear(disc);
    for (const Corner& corner : scene_.corners_) hear(corner);
    if (partly_hidden_) sweep();
    return best_;
  }

 private:
  bool matters(double far) const { return far <= cone_.reach && far < best_.distance; }

  /// Takes a point that reflects sound, unless a surface hides it.
  void offer(double far, Vec2 point) {
    if (!matters(far)) return;
    const Vec2 way = unitOr(point - cone_.apex, cone_.axis);
    if (scene_.castRay(cone_.apex, way, far - kSame).isHit()) {
      partly_hidden_ = true;
    } else {
      best_ = {far, point};
    }
  }

  /// A face is seen at angle a from its normal at the distance height * tan(a) along the face. The echo comes
  /// from the angles in the cone and within the limit; the smallest of them is nearest.
  void hear(const Face& face) {
    const double height = dot(cone_.apex - face.from, face.normal);
    if (height < 0.0 || !matters(height)) return;
    const double length = distance(face.from, face.to);
    const Vec2 along = (face.to - face.from) / length;
    const double axis = math::atan2(dot(cone_.axis, along), -dot(cone_.axis, face.normal));
    const double limit = std::min(limit_, kSteepest);
    const double low = std::max(axis - cone_.half_angle, -limit);
    const double high = std::min(axis + cone_.half_angle, limit);
    if (low > high) return;
    const double foot = dot(cone_.apex - face.from, along);
    const double from = std::max(0.0, foot + height * math::tan(low));
    const double to = std::min(length, foot + height * math::tan(high));
    if (from > to) return;
    const Vec2 point = face.from + along * std::clamp(foot, from, to);
    offer(distance(point, cone_.apex), point);
  }

  /// A disc reflects at the direction in the cone that is nearest to the disc's centre.
  void hear(const Disc& disc) {
    const Vec2 centre = disc.centre - cone_.apex;
    const double range = norm(centre);
    if (!matters(std::max(0.0, range - disc.radius))) return;
    if (range <= disc.radius) return offer(0.0, cone_.apex);
    const double bearing = signedAngle(cone_.axis, centre);
    const double off = std::max(0.0, std::abs(bearing) - cone_.half_angle);
    if (off >= math::kPi / 2) return;
    const math::SinCos sc = math::sinCos(off);
    const double across = sc.sin * range, chord = disc.radius * disc.radius - across * across;
    if (chord < 0.0 || std::sqrt(chord) < cos_limit_ * disc.radius) return;
    const double far = sc.cos * range - std::sqrt(chord);
    const math::SinCos turn = math::sinCos(bearing > 0.0 ? -off : off);
    const Vec2 way = outOfFrame({turn.cos, turn.sin}, centre / range);
    offer(far, cone_.apex + way * far);
  }

  void hear(const Corner& corner) {
    const Vec2 to = corner.point - cone_.apex;
    const double far = norm(to);
    if (!matters(far) || std::abs(signedAngle(cone_.axis, to)) > cone_.half_angle) return;
    if (throwsBack(corner, unitOr(-to, -cone_.axis))) offer(far, corner.point);
  }

  bool throwsBack(const Corner& corner, Vec2 back) const {
    const double to_first = dot(corner.first, back), to_second = dot(corner.second, back);
    if (corner.hollow)
      return dot(corner.first, corner.second) <= kRightAngle && to_first >= 0.0 && to_second >= 0.0;
    const bool between = cross(corner.first, back) >= 0.0 && cross(back, corner.second) >= 0.0;
    return between || std::max(to_first, to_second) >= cos_limit_;
  }

  /// Some surfaces' nearest points are hidden. Rays find the nearest visible points.
  void sweep() {
    const int steps = static_cast<int>(std::ceil(cone_.half_angle / kRayStep));
    for (int i = -steps; i <= steps; ++i) {
      const Vec2 offset = math::unit(steps > 0 ? cone_.half_angle * i / steps : 0.0);
      const Vec2 way = outOfFrame(cone_.axis, offset);
      const RayHit hit = scene_.castRay(cone_.apex, way, std::min(cone_.reach, best_.distance));
      if (hit.isHit() && -dot(hit.normal, way) >= cos_limit_ && matters(hit.distance))
        best_ = {hit.distance, cone_.apex + way * hit.distance};
    }
  }

  const EchoScene& scene_;
  const Cone& cone_;
  double limit_;
  double cos_limit_;
  Echo best_;
  bool partly_hidden_ = false;
};

Echo EchoScene::castCone(const Cone& cone, double specular_limit) const {
  return Listener(*this, cone, specular_limit).listen();
}

}  // namespace fulbito
