#include "navigation/obstacles/echo_circles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {

/// One reading, world frame.
struct EchoCircles::Heard {
  Vec2 apex;
  Vec2 axis;
  const RangeReading& reading;

  /// Angle [rad] between the axis and the unit vector `way`.
  double off(Vec2 way) const { return std::abs(math::atan2(cross(axis, way), dot(axis, way))); }
};

namespace {

constexpr std::size_t kMost = 8;  // circles
// [rad] A round body is also heard a little beyond the cone's edge: 0.14 rad off its middle, the nearest
// point in the cone is less than 1 mm farther than the body.
constexpr double kBeyond = 0.14;
constexpr double kInside = 0.05;  // [rad] within the cone's edge, where a body cannot be missed
constexpr double kFirst = 4.0;    // credit of a new circle
constexpr double kFull = 12.0;    // most credit

constexpr Vec2 kAnyWay{1.0, 0.0};

}  // namespace

EchoCircles::EchoCircles(const Settings& settings) : settings_(settings) { circles_.reserve(kMost); }

void EchoCircles::reset() {
  circles_.clear();
  names_ = 0;
}

void EchoCircles::update(const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  for (Tracked& each : circles_) each.circle.loosen(settings_.drift * settings_.drift * scene.dt);
  for (const RangeReading& reading : scene.ranges) {
    takeIn({pose.position + outOfFrame(ahead, reading.mount.position),
            outOfFrame(ahead, math::unit(reading.mount.heading)), reading},
           scene.tick);
  }
  dropTwins(pose.position);
  const auto memory = static_cast<Tick>(settings_.memory / scene.dt);
  std::erase_if(circles_,
                [&](const Tracked& each) { return each.credit <= 0.0 || scene.tick - each.heard > memory; });
}

void EchoCircles::takeIn(const Heard& heard, Tick tick) {
  const RangeReading& reading = heard.reading;
  Tracked* best = nullptr;
  EchoCircle::Expectation expected;
  double least = settings_.gate;
  for (Tracked& each : circles_) {
    const EchoCircle::Expectation own = each.circle.expect(heard.apex);
    const double off = heard.off(own.way);
    if (off > reading.half_cone + kBeyond || own.range > reading.greatest) continue;
    const double excess = reading.heard ? reading.range - own.range : std::numeric_limits<double>::infinity();
    const double misfit = excess / std::sqrt(own.variance + settings_.noise * settings_.noise);
    if (std::abs(misfit) < least) {
      least = std::abs(misfit), best = &each, expected = own;
    } else if (misfit > settings_.gate && off < reading.half_cone - kInside) {
      each.credit -= 1.0;
    }
  }
  if (best == nullptr) return;
  best->circle.correct(expected, reading.range, settings_.noise);
  best->credit = std::min(best->credit + 1.0, kFull);
  best->heard = tick;
}

/// Of two circles that show the robot the same surface, the older one stays.
void EchoCircles::dropTwins(Vec2 robot) {
  const auto facing = [&](const Tracked& each) {
    const Vec2 centre = each.circle.centre();
    return centre + unitOr(robot - centre, kAnyWay) * each.circle.radius();
  };
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    for (std::size_t j = circles_.size() - 1; j > i; --j) {
      if (distance(facing(circles_[i]), facing(circles_[j])) < settings_.apart)
        circles_.erase(circles_.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

void EchoCircles::start(const EchoCircleStart& start, Tick tick) {
  const bool near = std::any_of(circles_.begin(), circles_.end(), [&](const Tracked& each) {
    return distance(start.surface, each.circle.centre()) < each.circle.radius() + settings_.apart;
  });
  if (!near && circles_.size() < kMost) circles_.push_back({EchoCircle(start), kFirst, tick, ++names_});
}

const EchoCircles::Tracked* EchoCircles::at(Vec2 place) const {
  const Tracked* found = nullptr;
  double least = settings_.apart;
  for (const Tracked& each : circles_) {
    const double off = std::abs(distance(place, each.circle.centre()) - each.circle.radius());
    if (off < least) least = off, found = &each;
  }
  return found;
}

const EchoCircles::Tracked* EchoCircles::named(int name) const {
  const auto found =
      std::find_if(circles_.begin(), circles_.end(), [&](const Tracked& each) { return each.name == name; });
  return found == circles_.end() ? nullptr : &*found;
}

bool EchoCircles::explains(Vec2 place, double slack) const {
  return std::any_of(circles_.begin(), circles_.end(), [&](const Tracked& each) {
    const Vec2 from = place - each.circle.centre();
    return norm(from) < each.circle.radius() + slack &&
           each.circle.surfaceDeviation(unitOr(from, kAnyWay)) < settings_.trusted;
  });
}

void EchoCircles::scan(const SectorCircle& sectors, const Pose2& pose, std::span<SectorHit> hits) {
  const Vec2 ahead = math::unit(pose.heading);
  for (const Tracked& each : circles_) {
    own_.assign(hits.size(), {std::numeric_limits<double>::infinity(), {}});
    const Vec2 centre = intoFrame(ahead, each.circle.centre() - pose.position);
    scanDisc(sectors, centre, each.circle.radius(), own_);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!(own_[i].distance < hits[i].distance)) continue;
      const Vec2 normal = outOfFrame(ahead, unitOr(own_[i].point - centre, kAnyWay));
      if (each.circle.surfaceDeviation(normal) < settings_.trusted) hits[i] = own_[i];
    }
  }
}

}  // namespace fulbito
