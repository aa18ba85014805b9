#include "navigation/methods/fields/limit_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kSideHold =
    0.02;  // [m] beyond the line of arrival, where the robot changes to the other orbit
constexpr double kAnyDistance = 1e9;
constexpr double kPostureShares[] = {1.0, 0.75, 0.5};  // shares of the posture radius, for goals near a wall

}  // namespace

double orbitHeading(Vec2 offset, double radius, double mu, bool clockwise) {
  const double pull = mu * (1.0 - squaredNorm(offset) / (radius * radius));
  const Vec2 round = clockwise ? -perp(offset) : perp(offset);
  return math::angleOf(round + offset * pull);
}

void LimitCycle::reset() {
  circles_.reset();
  posture_side_ = PassingSide::kUndecided;
}

Guidance LimitCycle::plan(const NavigationScene& scene) {
  goal_ = scene.goal.position;
  const double robot_radius = scene.robot->circumradius();
  circles_.begin(scene.obstacles.size());
  for (const DiscObstacle& o : scene.obstacles) {
    circles_.add({o.position, o.radius + robot_radius + params_.margin});
  }
  circles_.join();
  circles_.decideSides(
      scene.self.pose.position, goal_,
      {.hysteresis = params_.hysteresis, .inside = scene.field, .wall_margin = robot_radius});
  decidePosture(scene);
  return guidanceBy(*this);
}

void LimitCycle::decidePosture(const NavigationScene& scene) {
  posture_ = {};
  if (!scene.goal.heading) return;
  const Vec2 along = math::unit(*scene.goal.heading);
  const double left = cross(along, scene.self.pose.position - goal_);
  if (posture_side_ == PassingSide::kUndecided || std::abs(left) > kSideHold) {
    posture_side_ = left > 0.0 ? PassingSide::kLeft : PassingSide::kRight;
  }
  const Vec2 outward = posture_side_ == PassingSide::kLeft ? perp(along) : -perp(along);
  for (double share : kPostureShares) {
    const double radius = share * params_.posture_radius;
    posture_ = {goal_ + outward * radius, radius};
    if (wallClearance(*scene.field, posture_.centre) > radius + scene.robot->circumradius()) return;
  }
}

bool LimitCycle::postureActs(Vec2 p) const {
  if (posture_.radius <= 0.0) return false;
  const OnWay place = onWay(posture_.centre, p, goal_);
  return distance(p, posture_.centre) < posture_.radius ||
         (place.between() && std::abs(place.lateral) < posture_.radius);
}

double LimitCycle::heading(Vec2 p) const {
  const std::size_t blocking = circles_.nearestBlocking(p, goal_, kAnyDistance);
  const bool blocked = blocking != ClusteredCircles::kNone;
  if (postureActs(p) &&
      !(blocked && distance(p, circles_.circle(blocking).centre) < distance(p, posture_.centre))) {
    // Left of the line of arrival the orbit runs counter-clockwise, so that it passes the goal along the
    // line.
    return orbitHeading(p - posture_.centre, posture_.radius, params_.mu,
                        posture_side_ == PassingSide::kRight);
  }
  if (!blocked) return math::angleOf(goal_ - p);
  const Circle& circle = circles_.circle(blocking);
  if (p == circle.centre) return math::angleOf(p - goal_);
  return orbitHeading(p - circle.centre, circle.radius, params_.mu,
                      circles_.side(blocking, p, goal_) == PassingSide::kLeft);
}

NavigatorInfo limitCycleInfo() {
  using P = LimitCycle::Params;
  return describeNavigator<P, LimitCycle>(
      "limit-cycle", "stable orbits about the obstacles in the way", "Kim & Kim 2003; P.-G. Kim et al. 2006",
      {number("margin", &P::margin, 0.0, 0.5, "m", "what an orbit adds to the bodies' radii"),
       number("mu", &P::mu, 0.1, 20.0, "", "convergence to the orbit; larger values turn onto it later"),
       number("hysteresis", &P::hysteresis, 0.0, 3.0, "rad", "advantage that makes the robot change sides"),
       number("posture_radius", &P::posture_radius, 0.02, 1.0, "m",
              "radius of the orbit that leads to the arrival heading")});
}

}  // namespace fulbito
