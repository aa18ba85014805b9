#include "referee/restarts/restart_zone.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kRounding = 1e-6;  // [m]

/// The kind of zone in which the law wants a robot to be.
enum class Zone {
  kAnywhere,
  kOwnHalf,
  kOwnHalfOrCircle,
  kOutsideCircle,  ///< in the own half
  kBehindBall,
  kBeyondHalfWay,  ///< in the half without the ball
  kGoalLine,
  kAwayFromBall,
  kInOwnArea,
  kTouchOwnArea,
  kOutsideTakersArea,
  kBehindAreaEdge
};

Zone freeKickZone(RestartPart part) {
  if (part.takes) return part.role == RestartRole::kKicker ? Zone::kBehindBall : Zone::kOwnHalf;
  return part.role == RestartRole::kKeeper ? Zone::kInOwnArea : Zone::kTouchOwnArea;
}

Zone penaltyZone(RestartPart part) {
  if (part.takes && part.role == RestartRole::kKicker) return Zone::kBehindBall;
  if (!part.takes && part.role == RestartRole::kKeeper) return Zone::kGoalLine;
  return Zone::kBeyondHalfWay;
}

Zone zoneOf(const RestartScene& scene, RestartPart part) {
  switch (scene.kind) {
    case RestartKind::kKickOff:
      if (part.takes) return Zone::kOwnHalfOrCircle;
      return scene.defenders_back ? Zone::kBehindAreaEdge : Zone::kOutsideCircle;
    case RestartKind::kFreeBall:
      return Zone::kAwayFromBall;
    case RestartKind::kFreeKick:
      return freeKickZone(part);
    case RestartKind::kPenalty:
      return penaltyZone(part);
    case RestartKind::kGoalKick:
      if (part.takes) return part.role == RestartRole::kKeeper ? Zone::kInOwnArea : Zone::kOutsideTakersArea;
      return scene.rules->goal_kick.opponents == GoalKickOpponents::kOwnHalf ? Zone::kOwnHalf
                                                                             : Zone::kOutsideTakersArea;
    case RestartKind::kGiven:
      break;
  }
  return Zone::kAnywhere;
}

/// Sign of x of the own goal: the taker defends +x.
double ownSign(RestartPart part) { return part.takes ? 1.0 : -1.0; }

/// Distance [m] of the area's front line from the centre.
double areaFront(const FieldGeometry& field) { return field.length / 2 - field.goal_area_depth; }

/// The rectangle about the arc of the area at +x.
PlacedBody arcBox(const FieldGeometry& field) {
  return {{areaFront(field) - field.goal_area_arc_depth / 2, 0.0},
          {1.0, 0.0},
          field.goal_area_arc_depth / 2,
          field.goal_area_arc_width / 2};
}

bool inTakersArea(const FieldGeometry& field, const PlacedBody& body) {
  if (!apart(body, goalAreaBox(field, 1.0), -kRounding)) return true;
  const bool arc = field.goal_area_arc_width > 0.0 && field.goal_area_arc_depth > 0.0;
  return arc && !apart(body, arcBox(field), -kRounding);
}

/// Limits of the body's centre in a box-shaped zone, given its reach, in the robot's own frame: `x` points to
/// the own goal.
struct Box {
  double x_low = -1e9, x_high = 1e9;
  double y_low = 0.0, y_high = 1e9;  ///< limits of |y|
};

Box boxOf(const RestartScene& scene, Zone zone, RestartPart part, const PlacedBody& body) {
  const FieldGeometry& field = *scene.field;
  const double x = body.reachX(), y = body.reachY();
  const double front = areaFront(field);
  switch (zone) {
    case Zone::kOwnHalf:
    case Zone::kOutsideCircle:
      return {x};
    case Zone::kBeyondHalfWay:
      // The mark is at -x of the taker's frame: all other robots stay at +x.
      return part.takes ? Box{x} : Box{-1e9, -x};
    case Zone::kBehindBall:
      return {scene.ball.x + x};
    case Zone::kGoalLine: {
      const double line = field.length / 2 - x;
      const double slack = scene.rules->penalty.keeper_line;
      return {line - slack, line + slack, 0.0, field.goal_width / 2};
    }
    case Zone::kInOwnArea:
      return {front, field.length / 2, 0.0, field.goal_area_width / 2};
    case Zone::kTouchOwnArea:
      return {front - x - scene.rules->free_kick.touch, front - x, field.goal_area_arc_width / 2 + y,
              field.goal_area_width / 2};
    case Zone::kBehindAreaEdge:
      return {front - x - scene.rules->free_kick.touch};
    default:
      return {};
  }
}

/// The same at a side line of the own area, for robots that touch it there.
Box besideArea(const RestartScene& scene, const PlacedBody& body) {
  const FieldGeometry& field = *scene.field;
  const double y = field.goal_area_width / 2 + body.reachY();
  return {areaFront(field), field.length / 2 - body.reachX(), y, y + scene.rules->free_kick.touch};
}

bool within(const Box& box, double own, Vec2 p) {
  const double x = own * p.x, y = std::abs(p.y);
  return x >= box.x_low - kRounding && x <= box.x_high + kRounding && y >= box.y_low - kRounding &&
         y <= box.y_high + kRounding;
}

Vec2 clamped(const Box& box, double own, Vec2 p) {
  return {own * std::clamp(own * p.x, box.x_low, std::max(box.x_low, box.x_high)),
          (p.y < 0.0 ? -1.0 : 1.0) * std::clamp(std::abs(p.y), box.y_low, std::max(box.y_low, box.y_high))};
}

/// `p` moved away from `from` to the distance `least`; along `fallback` if both are equal.
Vec2 pushedFrom(Vec2 from, Vec2 p, double least, Vec2 fallback) {
  if (distance(from, p) >= least) return p;
  return from + unitOr(p - from, fallback) * (least + kRounding);
}

std::string_view boxFault(Zone zone) {
  switch (zone) {
    case Zone::kBeyondHalfWay:
      return "is not beyond the half-way line";
    case Zone::kBehindBall:
      return "is not behind the ball";
    case Zone::kGoalLine:
      return "is not on its goal line";
    case Zone::kInOwnArea:
      return "is not in its goal area";
    case Zone::kTouchOwnArea:
      return "does not touch its goal area next to the arc";
    case Zone::kBehindAreaEdge:
      return "is in front of its goal area's edge";
    default:
      return "is not in its own half";
  }
}

double circleRadius(const RestartScene& scene) {
  return scene.field->centre_circle_radius + scene.rules->kick_off.circle_margin;
}

}  // namespace

PlacedBody goalAreaBox(const FieldGeometry& field, double sign) {
  return {{sign * (field.length / 2 - field.goal_area_depth / 2), 0.0},
          {1.0, 0.0},
          field.goal_area_depth / 2,
          field.goal_area_width / 2};
}

std::string_view zoneFlaw(const RestartScene& scene, RestartPart part, const PlacedBody& body) {
  const Zone zone = zoneOf(scene, part);
  const double own = ownSign(part);
  const Vec2 p = body.centre;
  switch (zone) {
    case Zone::kAwayFromBall:
      if (distance(p, scene.ball) < scene.rules->free_ball.distance - kRounding)
        return "is too close to the ball";
      return {};
    case Zone::kOutsideTakersArea:
      return inTakersArea(*scene.field, body) ? "is in the kicking team's goal area" : "";
    case Zone::kOwnHalfOrCircle:
      if (norm(p) <= scene.field->centre_circle_radius || own * p.x - body.reachX() >= -kRounding) return {};
      return "is neither in its own half nor in the circle";
    case Zone::kOutsideCircle:
      if (norm(p) < circleRadius(scene) - kRounding) return "is in the centre circle";
      break;
    default:
      break;
  }
  if (zone == Zone::kTouchOwnArea && within(besideArea(scene, body), own, p)) return {};
  return within(boxOf(scene, zone, part, body), own, p) ? "" : boxFault(zone);
}

Vec2 intoZone(const RestartScene& scene, RestartPart part, const PlacedBody& body) {
  const Zone zone = zoneOf(scene, part);
  const double own = ownSign(part);
  Vec2 p = clampedToField(*scene.field, body.centre, body.reachX(), body.reachY());
  const Vec2 back{own, 0.0};
  if (zone == Zone::kAwayFromBall) return pushedFrom(scene.ball, p, scene.rules->free_ball.distance, back);
  if (zone == Zone::kOutsideTakersArea) {
    PlacedBody moved = body;
    moved.centre = p;
    if (!inTakersArea(*scene.field, moved)) return p;
    return {areaFront(*scene.field) - scene.field->goal_area_arc_depth - body.reachX() - kRounding, p.y};
  }
  const bool in_circle = zone == Zone::kOwnHalfOrCircle && norm(p) <= scene.field->centre_circle_radius;
  if (in_circle) return p;
  const Box box = boxOf(scene, zone == Zone::kOwnHalfOrCircle ? Zone::kOwnHalf : zone, part, body);
  const Vec2 moved = clamped(box, own, p);
  if (zone == Zone::kOutsideCircle) return pushedFrom({}, moved, circleRadius(scene), back);
  if (zone == Zone::kTouchOwnArea) {
    const Vec2 beside = clamped(besideArea(scene, body), own, p);
    if (distance(beside, p) < distance(moved, p)) return beside;
  }
  return moved;
}

}  // namespace fulbito
