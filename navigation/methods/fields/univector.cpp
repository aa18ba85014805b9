#include "navigation/methods/fields/univector.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr double kHold = 0.3;         // [s]
constexpr double kSaddle = 2.0;       // [rad] two fields with a larger angle between them count as opposed
constexpr double kLeastDelta = 1e-3;  // [m]

}  // namespace

void Univector::reset() {
  held_ = 0;
  held_since_ = 0;
}

Guidance Univector::plan(const NavigationScene& scene) {
  goal_.aim(scene.goal);
  sources_.clear();
  for (const DiscObstacle& o : scene.obstacles) {
    const double extra = extraSize(o, *scene.robot);
    const double room = distance(scene.goal.position, o.position) - params_.d_min - extra;
    const double delta = params_.shrink
                             ? std::clamp(0.5 * room, kLeastDelta, std::max(kLeastDelta, params_.delta))
                             : params_.delta;
    sources_.push_back({o.position, params_.k0 * (o.velocity - scene.self.velocity), extra, delta});
  }
  if (params_.hold_side) holdSide(scene);
  return guidanceBy(*this);
}

Univector::Influence Univector::nearest(Vec2 p) const {
  Influence best;
  const double to_goal = distance(p, goal_.goal());
  for (const Source& source : sources_) {
    const double gap = distance(p, source.position), shift = norm(source.shift);
    if (params_.ignore_beyond && gap > to_goal) continue;
    const Vec2 moved = gap >= shift ? source.shift : source.shift * (gap / shift);
    const Vec2 away = p - (source.position + moved);
    const double distance_left = norm(away) - source.extra;
    if (best.source == nullptr || distance_left < best.distance) best = {&source, distance_left, away};
  }
  return best;
}

double Univector::heading(Vec2 p) const {
  const double to_goal = goal_.heading(p);
  const Influence near = nearest(p);
  if (near.source == nullptr) return to_goal;
  const double away = near.away == Vec2{} ? to_goal : math::angleOf(near.away);
  const double beyond = near.distance - params_.d_min;
  if (beyond <= 0.0) return away;
  const double share = math::exp(-beyond * beyond / (2.0 * near.source->delta * near.source->delta));
  double turn = math::wrapAngle(away - to_goal);
  if (held_ != 0 && std::abs(turn) > kSaddle && turn * held_ < 0.0) turn += held_ * 2.0 * math::kPi;
  return math::wrapAngle(to_goal + share * turn);
}

void Univector::holdSide(const NavigationScene& scene) {
  const Vec2 p = scene.self.pose.position;
  const Influence near = nearest(p);
  const double turn =
      near.source == nullptr ? 0.0 : math::wrapAngle(math::angleOf(near.away) - goal_.heading(p));
  const bool expired = static_cast<double>(scene.tick - held_since_) * scene.dt >= kHold;
  if (std::abs(turn) <= kSaddle) {
    held_ = 0;
  } else if (held_ == 0 || expired) {
    held_ = turn < 0.0 ? -1 : 1;
    held_since_ = scene.tick;
  }
}

NavigatorInfo univectorInfo() {
  using P = Univector::Params;
  return describeNavigator<P, Univector>(
      "univector", "univector field with virtual obstacles", "Kim, Kim & Kwon 2001; Lim et al. 2008",
      withGoalFieldParameters<P>(
          {number("d_min", &P::d_min, 0.0, 1.0, "m",
                  "distance from a ball-sized obstacle's centre up to which the field points straight away"),
           number("delta", &P::delta, 0.001, 1.0, "m",
                  "width of the Gaussian weight of the obstacle beyond d_min"),
           number("k0", &P::k0, 0.0, 1.0, "s", "shift of the virtual obstacle per relative velocity"),
           flag("hold_side", &P::hold_side, "keep the turning side in front of an obstacle for 0.3 s"),
           flag("shrink", &P::shrink, "narrow the Gaussian of obstacles near the goal"),
           flag("ignore_beyond", &P::ignore_beyond, "ignore obstacles farther away than the goal")}));
}

}  // namespace fulbito
