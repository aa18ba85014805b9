#include "navigation/tangent_path.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito {
namespace {

constexpr double kCreaseSin = 0.0871557427476582;  // sin 5 deg: kink where a turn joins the straight
constexpr double kCreaseCos = 0.9961946980917455;
constexpr double kOnStraight = 0.015;         // [m] beside the final straight that count as on it
constexpr double kAlong = 0.9;                // cosine of the heading that counts as along it
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
  const double radius = scene.robot->circumradius(), wanted = radius + params_.margin + extra;
  const bool heading = scene.goal.heading.has_value() && !onFinalStraight(scene);
  if (heading && search(scene, bodies, wanted, true)) return Outcome::kFound;
  if (search(scene, bodies, wanted, false)) {
    return heading ? Outcome::kAnyHeading : Outcome::kFound;
  }
  if (search(scene, bodies, radius, false)) return Outcome::kTight;
  if (search(scene, bodies, scene.robot->width / 2 + params_.narrowing, false)) return Outcome::kTight;
  passes_.clear();
  target_ = goal_;
  length_ = distance(start_, goal_);
  return Outcome::kNone;
}

bool TangentPath::onFinalStraight(const NavigationScene& scene) const {
  if (!scene.goal.heading) return false;
  const Vec2 along = math::unit(*scene.goal.heading), left = goal_ - start_;
  const double ahead = dot(left, along);
  return ahead > 0.0 && ahead < params_.approach && std::abs(cross(along, left)) < kOnStraight &&
         dot(along, math::unit(scene.self.pose.heading)) > kAlong;
}

bool TangentPath::search(const NavigationScene& scene, std::span<const Circle> bodies, double inflation,
                         bool approach) {
  circles_.clear();
  for (const Circle& body : bodies) circles_.push_back({body.centre, body.radius + inflation});
  target_ = approach ? addGate(scene) : goal_;
  const double penalty = params_.hysteresis * distance(start_, target_);
  found_ = graph_.search(start_, target_, circles_, scene.field, scene.robot->circumradius(),
                         {passes_, penalty});
  if (!found_) return false;
  passes_.assign(graph_.passes().begin(), graph_.passes().end());
  length_ = graph_.length();
  return true;
}

// The discs overlap a little, so that the gate between them is a notch open to the rear only.
Vec2 TangentPath::addGate(const NavigationScene& scene) {
  const Vec2 along = math::unit(*scene.goal.heading);
  const Vec2 gate = goal_ - along * params_.approach, aside = perp(along) * (params_.bend * kCreaseCos);
  circles_.push_back({gate + aside, params_.bend});
  circles_.push_back({gate - aside, params_.bend});
  return gate - along * (params_.bend * kCreaseSin);
}

void TangentPath::sample(double spacing, std::vector<Vec2>& out) const {
  out.clear();
  if (found_) {
    graph_.sample(spacing, out);
  } else {
    out.push_back(start_);
  }
  if (out.size() < 2 || !(target_ == goal_)) out.push_back(goal_);
}

}  // namespace fulbito
