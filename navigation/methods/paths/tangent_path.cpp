#include "navigation/methods/paths/tangent_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kCreaseSin = 0.0871557427476582;  // sin 5 deg: greatest kink between a turn and the straight
constexpr double kCreaseCos = 0.9961946980917455;
constexpr double kLeastApproach = 0.03;  // [m]
constexpr double kApproachStep = 0.005;  // [m]
constexpr double kBesideWall = 0.010;    // [m] of room for a turn in place
constexpr double kCrawl = 0.12;          // [m/s] while the robot turns
constexpr double kTurningRoom = 0.045;   // [m] before and after a turn in place, driven slowly
constexpr double kBrakingShare = 0.5;    // share of the wheel acceleration
constexpr double kOnStraight = 0.015;    // [m] a point nearer to the final straight counts as on it
constexpr double kAlong = 0.9;           // cosine; a smaller angle to the final straight counts as along it
constexpr double kSpacing = 0.01;        // [m] between the sampled points
constexpr std::size_t kReservedPasses = 32;

}  // namespace

TangentPath::TangentPath(TangentPathParams params) : params_(params) {
  circles_.reserve(kReservedPasses);
  passes_.reserve(kReservedPasses);
}

void TangentPath::reset() { passes_.clear(); }

TangentPath::Outcome TangentPath::plan(const NavigationScene& scene, std::span<const Circle> bodies,
                                       double extra) {
  start_ = scene.self.pose.position;
  goal_ = scene.goal.position;
  outcome_ = choose(scene, bodies, scene.robot->circumradius() + params_.margin + extra);
  if (outcome_ == Outcome::kNone) {
    passes_.clear();
    target_ = goal_;
    length_ = distance(start_, goal_);
  }
  return outcome_;
}

TangentPath::Outcome TangentPath::choose(const NavigationScene& scene, std::span<const Circle> bodies,
                                         double wanted) {
  const bool heading = scene.goal.heading.has_value() && !onFinalStraight(scene);
  if (heading && searchWithHeading(scene, bodies, wanted))
    return corner_ ? Outcome::kCorner : Outcome::kFound;
  if (search(scene, bodies, wanted)) return heading ? Outcome::kAnyHeading : Outcome::kFound;
  if (search(scene, bodies, scene.robot->circumradius())) return Outcome::kTight;
  if (search(scene, bodies, scene.robot->width / 2 + params_.narrowing)) return Outcome::kTight;
  return Outcome::kNone;
}

double TangentPath::speedCap(const NavigationScene& scene) const {
  if (outcome_ == Outcome::kNone) return 0.0;
  if (outcome_ != Outcome::kCorner && outcome_ != Outcome::kAnyHeading) {
    return std::numeric_limits<double>::infinity();
  }
  const double left = std::max(0.0, distance(scene.self.pose.position, target_) - kTurningRoom);
  return kCrawl + stoppingSpeed(kBrakingShare * scene.robot->wheel_acceleration, left);
}

bool TangentPath::onFinalStraight(const NavigationScene& scene) const {
  if (!scene.goal.heading) return false;
  const Vec2 along = math::unit(*scene.goal.heading), left = goal_ - start_;
  const double ahead = dot(left, along);
  return ahead > 0.0 && ahead < params_.approach && std::abs(cross(along, left)) < kOnStraight &&
         dot(along, math::unit(scene.self.pose.heading)) > kAlong;
}

bool TangentPath::searchWithHeading(const NavigationScene& scene, std::span<const Circle> bodies,
                                    double inflation) {
  if (!scene.goal.heading) return false;
  along_ = math::unit(*scene.goal.heading);
  approach_ = approachLength(scene);
  if (approach_ < kLeastApproach) return false;
  for (double bend : {params_.bend, params_.bend / 2, 0.0}) {
    corner_ = bend == 0.0;
    if (search(scene, bodies, inflation, bend)) return true;
  }
  return false;
}

bool TangentPath::search(const NavigationScene& scene, std::span<const Circle> bodies, double inflation,
                         std::optional<double> bend) {
  circles_.clear();
  for (const Circle& body : bodies) circles_.push_back({body.centre, body.radius + inflation});
  target_ = bend ? addGate(*bend) : goal_;
  const double penalty = params_.hysteresis * distance(start_, target_);
  found_ =
      graph_.search(start_, target_, circles_, scene.field, scene.robot->circumradius(), {passes_, penalty});
  if (!found_) return false;
  passes_.assign(graph_.passes().begin(), graph_.passes().end());
  length_ = graph_.length();
  return true;
}

/// The wanted length [m] of the final straight, or less so that the robot can turn where it begins.
double TangentPath::approachLength(const NavigationScene& scene) const {
  const double room = scene.robot->circumradius() + kBesideWall;
  double length = params_.approach;
  while (length >= kLeastApproach && wallClearance(*scene.field, goal_ - along_ * length) < room) {
    length -= kApproachStep;
  }
  return length;
}

// The discs overlap slightly, so that the gate between them is a notch that is open only to the rear.
Vec2 TangentPath::addGate(double bend) {
  const Vec2 gate = goal_ - along_ * (approach_ - bend * kCreaseSin),
             aside = perp(along_) * (bend * kCreaseCos);
  if (bend > 0.0) {
    circles_.push_back({gate + aside, bend});
    circles_.push_back({gate - aside, bend});
  }
  return goal_ - along_ * approach_;
}

void TangentPath::sample(std::vector<Vec2>& out) const {
  out.clear();
  if (found_) {
    graph_.sample(kSpacing, out);
  } else {
    out.push_back(start_);
  }
  if (out.size() < 2 || !(target_ == goal_)) out.push_back(goal_);
}

}  // namespace fulbito
