#include "navigation/methods/fields/goal_field.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// Turn [rad] of a spiral relative to the direction away from its centre, at the distance `rho`. It is pi/2,
/// along the circle, at `radius`, and approaches pi, toward the centre, far away.
double spiralTurn(double rho, double radius, double smoothness) {
  if (rho > radius) return math::kPi / 2 * (2.0 - (radius + smoothness) / (rho + smoothness));
  return math::kPi / 2 * std::sqrt(rho / radius);
}

}  // namespace

double spiralHeading(Vec2 p, Vec2 goal, double arrival, double radius, double smoothness) {
  const Vec2 local = intoFrame(math::unit(arrival), p - goal);
  const auto about = [&](double side) {
    const Vec2 from_centre{local.x, local.y - side * radius};
    return math::angleOf(from_centre) + side * spiralTurn(norm(from_centre), radius, smoothness);
  };
  if (local.y >= radius) return math::wrapAngle(about(1.0) + arrival);
  if (local.y < -radius) return math::wrapAngle(about(-1.0) + arrival);
  const Vec2 sum = math::unit(about(1.0)) * (local.y + radius) + math::unit(about(-1.0)) * (radius - local.y);
  // On the line beyond the goal the two spirals cancel at one point. Either turn leads round the goal there.
  const double turn = squaredNorm(sum) > 0.0 ? math::angleOf(sum) : math::kPi / 2;
  return math::wrapAngle(turn + arrival);
}

double postureHeading(Vec2 p, Vec2 goal, double arrival, double sharpness, double guide) {
  if (p == goal) return arrival;
  const double to_goal = math::angleOf(goal - p);
  const double to_guide = math::angleOf(goal + math::unit(arrival) * guide - p);
  // A turn above pi would fold the field, and its streamlines would loop.
  const double turn = std::clamp(sharpness * math::wrapAngle(to_guide - to_goal), -math::kPi, math::kPi);
  return math::wrapAngle(to_goal - turn);
}

void GoalField::aim(const NavigationGoal& goal) {
  goal_ = goal.position;
  arrival_ = params_.kind == GoalFieldKind::kBearing ? std::nullopt : goal.heading;
}

double GoalField::heading(Vec2 p) const {
  if (!arrival_) return math::angleOf(goal_ - p);
  if (params_.kind == GoalFieldKind::kPosture) {
    return postureHeading(p, goal_, *arrival_, params_.sharpness, params_.guide);
  }
  return spiralHeading(p, goal_, *arrival_, params_.spiral_radius, params_.spiral_smoothness);
}

}  // namespace fulbito
