#include "navigation/methods/hybrid/strip_guide.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Lengths at a body of 7.5 cm.
constexpr double kAhead = 0.17;         // [m] of the way in which a narrow place is looked for
constexpr double kClear = 0.055;        // [m] clearance of its middle, below
constexpr double kLeast = 0.072;        // [m] width of a strip: cells stand out a little
constexpr double kWidest = 0.13;        // [m] of one that needs a guide
constexpr double kStillNarrow = 0.125;  // [m] of a strip that is followed
constexpr double kBefore = 0.005;       // [m] before the entry, at least, to begin
constexpr double kBeside = 0.008;       // [m] off the axis at the entry, at most ...
constexpr double kSlope = 0.6;          // ... and with the distance before it
constexpr double kLean = 0.7;           // [rad] off the axis to begin
constexpr double kSlack = 0.005;        // [m] more than that, to give up
constexpr double kStage = 0.08;         // [m] before the entry
constexpr double kAtStage = 0.015;      // [m]
constexpr Tick kStageTicks = 60;        // after which the stage is looked for again
constexpr double kGate = 0.02;          // [m] before the entry, where the robot has to be straight
constexpr double kBehindGate = 0.004;   // [m] behind it
constexpr double kStraight = 0.005;     // [m] off the axis there
constexpr double kSquare = 0.12;        // [rad] off the axis there
constexpr double kBackOut = 0.06;       // [m]
constexpr double kOut = 0.015;          // [m] behind the exit, where the rear is out
constexpr double kFarOff = 0.25;        // [m]
constexpr int kLostTicks = 20;
constexpr double kReach = 0.04;                   // [m] along the axis to the point that the robot steers at
constexpr double kMargin = 0.0;                   // [m] kept in the place
constexpr double kStageMargin = 0.006;            // [m] and before it
constexpr double kShare = 0.3, kTurnShare = 0.2;  // of what the map shows anew, in the strip
constexpr double kFrontShare = 0.042;             // of how far the front is off the middle
constexpr double kCorner = 0.04;                  // [m] ranges that count
constexpr double kAsideShare = 0.766;             // of a front corner's range: its bearing is 50 degrees
constexpr double kCornerGain = 80.0;              // [rad/(s m)] turn away from the nearer side
constexpr double kTouching = 0.003;               // [m] so near to a side the front goes no farther
constexpr double kSpeed = 0.06, kBackSpeed = 0.07, kStageSpeed = 0.08, kCareful = 0.03,
                 kBackOff = 0.05;  // [m/s]
constexpr double kMostRate = 1.5;  // [rad/s]

double rateFor(double error, double gain = 6.0, double most = kMostRate) {
  return std::clamp(gain * error, -most, most);
}

bool isPassable(const FreeStrip& strip, double widest, double size) {
  return strip.width > kLeast * size && strip.width < widest * size;
}

double leanOf(const FreeStrip& strip, const Pose2& pose) {
  return math::wrapAngle(pose.heading - math::angleOf(strip.axis));
}

/// How far [m] the robot's front is beyond the entry.
double frontOf(const FreeStrip& strip, const NavigationScene& scene) {
  return strip.along(scene.self.pose.position) + scene.robot->length / 2 - strip.entry;
}

bool isBefore(const FreeStrip& strip, const NavigationScene& scene, double size, double slack) {
  const double front = frontOf(strip, scene), aside = std::abs(strip.aside(scene.self.pose.position));
  return aside < (kBeside + slack) * size + kSlope * std::max(0.0, -front) &&
         std::abs(leanOf(strip, scene.self.pose)) < kLean + (slack > 0.0 ? 0.2 : 0.0);
}

}  // namespace

void StripGuide::reset() {
  strip_.reset(), stage_.reset();
  backs_out_ = false, lost_ = 0;
}

std::optional<Twist> StripGuide::drive(const View& view) {
  if (strip_) follow(view);
  if (!strip_) begin(view);
  if (!strip_ && stage_ && view.scene.tick < stage_until_) {
    if (auto twist = toStage(view)) return twist;
    stage_.reset();
  }
  return strip_ ? through(view) : std::nullopt;
}

/// Keeps the strip where the map and the front corners' sonars show it, and drops it behind its exit.
void StripGuide::follow(const View& view) {
  const double along = strip_->along(view.scene.self.pose.position), half = view.scene.robot->length / 2;
  const double rear = half + kOut * view.size;
  const bool inside = frontOf(*strip_, view.scene) > 0.0;
  if (inside) StripFinder::prolong(view.map, view.scene.self.pose.position, rear, view.size, *strip_);
  if (along > strip_->exit + rear || std::abs(along) > kFarOff * view.size) return reset();
  const auto next = finder_.find(view.map, strip_->middle, strip_->axis, view.size);
  if (!next || !isPassable(*next, kStillNarrow, view.size)) {
    if (++lost_ > kLostTicks && !inside) reset();
    return;
  }
  lost_ = 0;
  const double shift = cross(next->axis, next->middle - strip_->middle);
  strip_->axis = unitOr(strip_->axis * (1.0 - kTurnShare) + next->axis * kTurnShare, next->axis);
  strip_->middle += perp(strip_->axis) * (kShare * shift);
  if (inside) strip_->middle -= perp(strip_->axis) * (kFrontShare * frontOffset(view));
  strip_->width = next->width, strip_->entry = next->entry, strip_->exit = next->exit;
}

/// What the front corners' sonars hear of the sides: the room on the left and on the right [m].
StripGuide::FrontRoom StripGuide::frontRoom(const View& view) const {
  const double most = kCorner * view.size;
  FrontRoom room;
  if (view.left && *view.left < most) room.left = kAsideShare * *view.left;
  if (view.right && *view.right < most) room.right = kAsideShare * *view.right;
  return room;
}

/// How far [m] the front is to the left of the middle. A side that is not heard is where the map has it.
double StripGuide::frontOffset(const View& view) const {
  const FrontRoom room = frontRoom(view);
  const double half = std::max(0.0, strip_->width + view.map.cell() - view.scene.robot->width) / 2;
  if (room.left && room.right) return (*room.right - *room.left) / 2;
  if (room.left) return std::max(0.0, half - *room.left);
  return room.right ? std::min(0.0, *room.right - half) : 0.0;
}

/// Looks for the narrowest place on the way near ahead.
void StripGuide::begin(const View& view) {
  const std::span<const Vec2> path = view.way.path();
  double least = kClear * view.size, length = 0.0;
  std::size_t at = path.size();
  for (std::size_t i = 0; i + 2 < path.size() && length < kAhead * view.size; ++i) {
    length += distance(path[i], path[i + 1]);
    const double clear = view.way.clearance(view.map, path[i]);
    if (clear < least - 1e-6) least = clear, at = i;
  }
  if (at >= path.size()) return;
  const Pose2& pose = view.scene.self.pose;
  const std::size_t before = at >= 4 ? at - 4 : 0, after = std::min(at + 4, path.size() - 1);
  const Vec2 way = unitOr(path[after] - path[before], math::unit(pose.heading));
  const auto found = finder_.find(view.map, path[at], way, view.size);
  if (!found || !isPassable(*found, kWidest, view.size)) return;
  const double front = frontOf(*found, view.scene);
  if (front < -2.0 * kBefore * view.size && isBefore(*found, view.scene, view.size, 0.0)) {
    reset();
    strip_ = found;
  } else if (front < -kBefore * view.size) {
    const double back = found->entry - view.scene.robot->length / 2 - kStage * view.size;
    stage_ = Pose2{found->middle + found->axis * back, math::angleOf(found->axis)};
    stage_until_ = view.scene.tick + kStageTicks;
  }
}

/// To the stage, forward or backward, and there square to the place; empty once there or where it is blocked.
std::optional<Twist> StripGuide::toStage(const View& view) {
  const Pose2& pose = view.scene.self.pose;
  const double margin = kStageMargin * view.size;
  const Vec2 to = stage_->position - pose.position;
  if (norm(to) < kAtStage * view.size) {
    const double error = math::wrapAngle(stage_->heading - pose.heading);
    if (std::abs(error) < 0.15 || !view.room.turns(rateFor(error), error, margin)) return {};
    return Twist{0.0, rateFor(error)};
  }
  double error = math::wrapAngle(math::angleOf(to) - pose.heading), side = 1.0;
  if (std::abs(error) > math::kPi / 2) error = math::wrapAngle(error + math::kPi), side = -1.0;
  Twist twist{std::abs(error) < 0.4 ? side * kStageSpeed * math::cos(error) : 0.0, rateFor(error)};
  if (!view.room.turns(twist.angular, error, margin)) {
    twist.angular = 0.0;
    if (twist.linear == 0.0) twist.linear = -kBackOff;
  }
  if (twist.linear != 0.0 &&
      view.room.at({0.15 * twist.linear, 0.0}, 0.1 * twist.angular) < view.room.floor(margin)) {
    twist.linear = 0.0;
    if (twist.angular == 0.0) return {};
  }
  return twist;
}

std::optional<Twist> StripGuide::backOut(const View& view, double aside) {
  const double margin = kMargin * view.size, step = -0.008 * view.size;
  if (view.room.at({step, 0.0}, 0.0) < view.room.floor(margin)) return {};
  const Vec2 straight = strip_->axis * (kReach * view.size) + perp(strip_->axis) * aside;
  const double error = math::wrapAngle(math::angleOf(straight) - view.scene.self.pose.heading);
  const double rate = rateFor(error, 6.0, 1.2);
  const bool turns = view.room.at({step, 0.0}, 0.1 * rate) >= view.room.floor(margin);
  return Twist{-kBackSpeed, turns ? rate : 0.0};
}

std::optional<Twist> StripGuide::through(const View& view) {
  const Pose2& pose = view.scene.self.pose;
  const double front = frontOf(*strip_, view.scene), aside = strip_->aside(pose.position);
  const double lean = leanOf(*strip_, pose), size = view.size;
  if (front < -kBefore * size && !isBefore(*strip_, view.scene, size, kSlack)) {
    reset();
    return {};
  }
  if (!backs_out_) backs_from_ = pose.position;
  const bool at_gate = front > -kGate * size && front < kBehindGate * size;
  if (at_gate && std::abs(aside) > kStraight * size) backs_out_ = true;
  if (distance(pose.position, backs_from_) > kBackOut * size) backs_out_ = false;
  if (backs_out_) {
    if (auto twist = backOut(view, aside)) return twist;
    backs_out_ = false;
  }
  if (at_gate && std::abs(lean) > kSquare) {
    if (view.room.turns(rateFor(-lean), lean, kMargin * size)) return Twist{0.0, rateFor(-lean)};
    backs_out_ = true;
  }
  return alongAxis(view, front, aside);
}

/// Turns away from the side that the front corners' sonars hear too near, and stops before a touch. A corner
/// itself is in no cone: what it nears, the map shows too late.
void StripGuide::keepOff(const View& view, Twist& twist) const {
  const double turn = kCornerGain / view.size * frontOffset(view), most = kTouching * view.size;
  twist.angular = std::clamp(twist.angular - turn, -kMostRate, kMostRate);
  const FrontRoom room = frontRoom(view);
  if (room.left.value_or(most) < most || room.right.value_or(most) < most) twist.linear = -kCareful;
}

Twist StripGuide::alongAxis(const View& view, double front, double aside) {
  const double margin = kMargin * view.size, floor = view.room.floor(margin);
  const Vec2 aim = strip_->axis * (kReach * view.size) - perp(strip_->axis) * aside;
  const double error = math::wrapAngle(math::angleOf(aim) - view.scene.self.pose.heading);
  Twist twist{std::abs(error) > 0.3 && front < 0.0 ? 0.0 : kSpeed, rateFor(error, 8.0)};
  if (front > 0.0) keepOff(view, twist);
  if (!view.room.turns(twist.angular, error, margin)) twist.angular = 0.0;
  if (twist.linear == 0.0 && twist.angular == 0.0 && view.room.at({-0.008 * view.size, 0.0}, 0.0) >= floor)
    return {-kBackOff, 0.0};
  const Vec2 next = math::unit(0.05 * twist.angular) * (0.010 * view.size);
  if (twist.linear > 0.0 && view.room.at(next, 0.1 * twist.angular) < floor) {
    const bool straight = view.room.at({0.005 * view.size, 0.0}, 0.0) >= floor;
    backs_out_ = backs_out_ || !straight;
    twist = {straight ? kCareful : 0.0, straight ? 0.0 : twist.angular};
  }
  return twist;
}

}  // namespace fulbito
