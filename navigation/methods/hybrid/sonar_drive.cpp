#include "navigation/methods/hybrid/sonar_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kCell = 0.005;       // [m] lengths at a body of 7.5 cm
constexpr Tick kSearchTicks = 10;     // between searches
constexpr double kNewPlace = 0.002;   // [m] a reading from so far off the last is a new one ...
constexpr double kNewTurn = 0.017;    // [rad] ... or turned by so much
constexpr double kOldShare = 0.15;    // what one from the same place tells
constexpr double kMoved = 0.012;      // [m] that a robot which is not stuck moves ...
constexpr double kTurned = 0.35;      // [rad] ... or turns ...
constexpr Tick kStuckTicks = 75;      // ... in this time
constexpr Tick kBackTicks = 40;       // for which it backs off
constexpr Tick kTurnBackTicks = 30;   // before a place without a guide
constexpr double kMargin = 0.006;     // [m] kept from everything
constexpr double kReach = 0.05;       // [m] along the way to the point that the robot steers at
constexpr double kFreeAhead = 0.09;   // [m] of the way whose clearance sets the speed
constexpr double kTightAhead = 0.05;  // [m] of the way where no narrow place may be without a guide
constexpr double kNarrow = 0.046, kSlowest = 0.045, kWide = 0.09;  // [m] clearances
constexpr double kSlowShare = 0.2;                                 // of the top speed in narrow places
constexpr double kNear = 0.02;                                     // [m]
constexpr double kGain = 6.0, kMostRate = 3.0, kNearRate = 1.5;    // [1/s, rad/s]
constexpr double kPause = 0.010, kTime = 0.3;                      // [m, s] to what is ahead
constexpr double kEscape = 0.03, kEscapeSpeed = 0.075;  // [m, m/s] of a motion that leaves a tight place
constexpr double kFace = 0.75;                          // [rad] sensors within this of the heading look ahead
constexpr double kSpin = 0.5;                           // [rad] larger errors are turned off in place
constexpr double kLookRate = 1.2;                       // [rad/s]
constexpr Tick kLookTicks = 90;

}  // namespace

void SonarDrive::reset() {
  for (RangeSmoother& each : smoothers_) each.reset();
  if (map_) map_->reset();
  way_.reset(), guide_.reset();
  next_search_ = back_until_ = moved_ = std::numeric_limits<Tick>::min() / 2;
}

Twist SonarDrive::drive(const NavigationScene& scene) {
  if (smoothers_.size() != scene.ranges.size() || size_ != bodySize(*scene.robot)) {
    size_ = bodySize(*scene.robot);
    smoothers_.assign(scene.ranges.size(), {}), last_.assign(scene.ranges.size(), {});
    map_.emplace(kCell * size_);
  }
  sense(scene);
  if (scene.tick >= next_search_) {
    way_.search(*map_, scene.self.pose.position, scene.goal.position, scene.robot->width / 2);
    next_search_ = scene.tick + kSearchTicks;
  }
  if (auto twist = backOff(scene)) return *twist;
  if (way_.path().size() < 2) return lookAbout(scene);
  const std::size_t left = 1, right = smoothers_.size() - 2;
  const StripGuide::View view{scene,
                              *map_,
                              way_,
                              room_,
                              size_,
                              right < smoothers_.size() ? smoothers_[left].recent() : std::nullopt,
                              right < smoothers_.size() ? smoothers_[right].recent() : std::nullopt};
  if (auto twist = guide_.drive(view)) return *twist;
  return alongWay(scene);
}

void SonarDrive::sense(const NavigationScene& scene) {
  map_->centre(scene.self.pose.position, scene.tick);
  for (std::size_t i = 0; i < scene.ranges.size(); ++i) {
    const auto reading = smoothers_[i].add(scene.ranges[i], scene.self.pose);
    if (!reading) continue;
    const double moved = distance(reading->apex, last_[i].apex) / (kNewPlace * size_) +
                         std::abs(cross(reading->axis, last_[i].axis)) / kNewTurn;
    last_[i] = *reading;
    map_->takeIn(*reading, std::clamp(moved, kOldShare, 1.0));
  }
  map_->clearBody(scene);
  room_.look(scene, *map_, smoothers_);
}

/// Backward, or else a little forward, where the robot has not moved for a while.
std::optional<Twist> SonarDrive::backOff(const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  const bool turned = std::abs(math::wrapAngle(pose.heading - rest_.heading)) > kTurned;
  if (distance(pose.position, rest_.position) > kMoved * size_ || turned) rest_ = pose, moved_ = scene.tick;
  if (scene.tick - moved_ > kStuckTicks && scene.tick >= back_until_)
    back_until_ = scene.tick + kBackTicks, moved_ = scene.tick, escape_.reset();
  if (scene.tick >= back_until_) return {};
  if (!escape_ || roomAfter(*escape_) < room_.floor(kMargin * size_)) escape_ = findEscape();
  if (escape_) return escape_;
  back_until_ = scene.tick;
  return {};
}

/// The least room on the next 3 cm of a motion.
double SonarDrive::roomAfter(Twist motion) const {
  const double time = kEscape * size_ / std::abs(motion.linear);
  const double turn = motion.angular * time, way = motion.linear * time;
  return std::min(room_.at(math::unit(turn / 4) * (way / 2), turn / 2),
                  room_.at(math::unit(turn / 2) * way, turn));
}

/// Straight back; where that is blocked, the arc that leaves most room; empty where all are blocked.
std::optional<Twist> SonarDrive::findEscape() const {
  double most = room_.floor(kMargin * size_);
  std::optional<Twist> best;
  if (roomAfter({-kEscapeSpeed, 0.0}) >= most) return Twist{-kEscapeSpeed, 0.0};
  for (const double side : {-1.0, 1.0}) {
    for (const double bend : {0.0, 4.0, -4.0, 8.0, -8.0}) {
      const Twist motion{side * kEscapeSpeed, kEscapeSpeed * bend / size_};
      const double room = roomAfter(motion);
      if (room > most) most = room + 0.0005 * size_, best = motion;
    }
  }
  return best;
}

Twist SonarDrive::lookAbout(const NavigationScene& scene) const {
  const double rate = (scene.tick / kLookTicks) % 2 != 0 ? kLookRate : -kLookRate;
  return {0.0, room_.turns(rate, 0.06, kMargin * size_) ? rate : 0.0};
}

/// The least that sensors within `widest` [rad] of the heading hear just now.
double SonarDrive::ahead(const NavigationScene& scene, double widest) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < smoothers_.size(); ++i) {
    if (std::abs(scene.ranges[i].mount.heading) < widest)
      least = std::min(least, smoothers_[i].recent().value_or(least));
  }
  return least;
}

Twist SonarDrive::alongWay(const NavigationScene& scene) {
  const Pose2& pose = scene.self.pose;
  const std::span<const Vec2> path = way_.path();
  std::size_t here = 0;
  for (std::size_t i = 1; i < std::min<std::size_t>(path.size(), 24); ++i) {
    if (distance(path[i], pose.position) < distance(path[here], pose.position)) here = i;
  }
  double length = 0.0, clear = kWide * size_, tight = clear;
  Vec2 aim = path.back();
  bool aimed = false;
  for (std::size_t i = here; i + 1 < path.size() && length < kFreeAhead * size_; ++i) {
    if (!aimed && length >= kReach * size_) aim = path[i], aimed = true;
    const double each = way_.clearance(*map_, path[i]);
    if (length < kTightAhead * size_) tight = std::min(tight, each);
    clear = std::min(clear, each), length += distance(path[i], path[i + 1]);
  }
  for (int i = 0; i <= 5; ++i)
    clear =
        std::min(clear, way_.clearance(*map_, pose.position - math::unit(pose.heading) * (0.01 * size_ * i)));
  if (tight < kNarrow * size_ && room_.here() < kNear * size_) {
    back_until_ = scene.tick + kTurnBackTicks, escape_.reset();
    return {};
  }
  const double error = math::wrapAngle(math::angleOf(aim - pose.position) - pose.heading);
  const double open = std::clamp((clear / size_ - kSlowest) / (kWide - kSlowest), 0.0, 1.0);
  const double cos = std::abs(error) > kSpin ? 0.0 : math::cos(error);
  double speed = scene.robot->maxSpeed() * (kSlowShare + (1.0 - kSlowShare) * open) * cos * cos;
  const double front = ahead(scene, kFace), corners = ahead(scene, 1.2);
  speed = std::min(speed, std::max(0.02, (front - kPause * size_) / kTime));
  const bool near = corners < 0.05 * size_ || room_.here() < 0.03 * size_;
  const double most = near && !room_.turnsFreely(kMargin * size_) ? kNearRate : kMostRate;
  return safe({speed, std::clamp(kGain * error, -most, most)}, error);
}

/// The part of a motion that leaves enough room. A body that cannot turn moves off first.
Twist SonarDrive::safe(Twist wanted, double error) const {
  const double margin = kMargin * size_, floor = room_.floor(margin);
  const auto leaves = [&](double way) { return room_.at({way * size_, 0.0}, 0.0) >= floor; };
  if (wanted.angular != 0.0 && !room_.turns(wanted.angular, error, margin)) {
    wanted.angular = 0.0;
    if (std::abs(error) > kSpin) {
      const double side = std::abs(error) < math::kPi / 2 ? 1.0 : -1.0;
      if (leaves(side * 0.012)) return {side * 0.05, 0.0};
      return {leaves(-side * 0.012) ? -side * 0.05 : 0.0, 0.0};
    }
  }
  const double turn = 0.1 * wanted.angular;
  const double way = 0.1 * wanted.linear + wanted.linear * wanted.linear / 3.0 + 0.003 * size_;
  if (wanted.linear <= 0.0 || room_.at(math::unit(turn / 2) * way, turn) >= floor) return wanted;
  if (!leaves(0.006)) return {0.0, wanted.angular};
  return {0.03, room_.at({0.006 * size_, 0.0}, turn) < floor ? 0.0 : wanted.angular};
}

}  // namespace fulbito
