#include "experiments/papers/localization/estimation/wall_ahead.hpp"

#include <cmath>

namespace fulbito::localization {
namespace {

/// Index of the nearest of the directions 0, 90, 180 and 270 degrees: 0 to 3.
int quarterOf(double angle) {
  const int quarter = static_cast<int>(std::floor(angle / (math::kPi / 2) + 0.5));
  return ((quarter % 4) + 4) % 4;
}

}  // namespace

WallAhead wallAhead(const Room& room, const Body& body, const Pose2& pose, Beam beam) {
  const double direction = math::wrapAngle(pose.heading + directionOf(beam));
  const double reach = reachOf(body, beam);
  const math::SinCos axis = math::sinCos(direction);
  const int quarter = quarterOf(direction);
  WallAhead wall;
  wall.across_x = quarter % 2 == 0;
  wall.sign = quarter < 2 ? 1.0 : -1.0;
  wall.incidence = math::wrapAngle(direction - quarter * (math::kPi / 2));
  const double sensor =
      wall.across_x ? pose.position.x + reach * axis.cos : pose.position.y + reach * axis.sin;
  const double extent = wall.across_x ? room.x : room.y;
  wall.distance = wall.sign > 0.0 ? extent - sensor : sensor;
  wall.by_heading = wall.sign * reach * (wall.across_x ? axis.sin : -axis.cos);
  return wall;
}

}  // namespace fulbito::localization
