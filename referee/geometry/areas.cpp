#include "referee/geometry/areas.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// A convex polygon, counter-clockwise. A rectangle cut by four lines has at most eight corners.
struct Polygon {
  std::array<Vec2, 8> corners;
  std::size_t size = 0;

  void add(Vec2 corner) { corners[size++] = corner; }
};

Polygon polygonOf(const AreaBody& body) {
  const Vec2 along = body.x_axis * body.half_length, across = perp(body.x_axis) * body.half_width;
  Polygon polygon;
  for (const Vec2 corner : {along + across, across - along, -along - across, along - across}) {
    polygon.add(body.centre + corner);
  }
  return polygon;
}

/// The part of the polygon with `dot(normal, p) <= offset`.
Polygon cut(const Polygon& polygon, Vec2 normal, double offset) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 a = polygon.corners[i], b = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
    const double beyond_a = dot(normal, a) - offset, beyond_b = dot(normal, b) - offset;
    if (beyond_a <= 0.0) kept.add(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      kept.add(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
    }
  }
  return kept;
}

double areaOf(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size; ++i) {
    twice += cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
  }
  return twice / 2;
}

/// The parts of the body in the area's straight part (`inStraightPart`) and in front of it (`inFront`).
Polygon inStraightPart(const AreaShape& area, const Polygon& body) {
  return cut(cut(cut(body, {1.0, 0.0}, area.depth), {0.0, 1.0}, area.half_width), {0.0, -1.0},
             area.half_width);
}
Polygon inFront(const AreaShape& area, const Polygon& body) { return cut(body, {-1.0, 0.0}, -area.depth); }

/// Area between the origin and the part from `a` to `b` of a circle about it, signed.
double sector(Vec2 a, Vec2 b, double radius) {
  return radius * radius / 2 * math::atan2(cross(a, b), dot(a, b));
}

/// Area that the disc about the origin shares with the triangle of the origin and the edge, signed.
double areaUnderEdge(Vec2 a, Vec2 b, double radius) {
  const Vec2 edge = b - a;
  const double along = dot(a, edge), length2 = squaredNorm(edge);
  const double discriminant = along * along - length2 * (squaredNorm(a) - radius * radius);
  if (length2 <= 0.0) return 0.0;
  if (discriminant <= 0.0) return sector(a, b, radius);
  const double root = std::sqrt(discriminant);
  const double enters = (-along - root) / length2, leaves = (root - along) / length2;
  if (leaves <= 0.0 || enters >= 1.0) return sector(a, b, radius);
  const Vec2 p = enters > 0.0 ? a + edge * enters : a;
  const Vec2 q = leaves < 1.0 ? a + edge * leaves : b;
  double area = cross(p, q) / 2;
  if (enters > 0.0) area += sector(a, p, radius);
  if (leaves < 1.0) area += sector(q, b, radius);
  return area;
}

double areaWithDisc(const Polygon& polygon, Vec2 centre, double radius) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 next = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
    area += areaUnderEdge(polygon.corners[i] - centre, next - centre, radius);
  }
  return area;
}

double squaredDistance(const Polygon& polygon, Vec2 p) {
  bool inside = polygon.size >= 3;
  double least = 1e300;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 a = polygon.corners[i];
    const Vec2 edge = polygon.corners[i + 1 == polygon.size ? 0 : i + 1] - a;
    const double length2 = squaredNorm(edge);
    const double along = length2 > 0.0 ? std::clamp(dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, squaredNorm(p - a - edge * along));
    inside = inside && cross(edge, p - a) >= 0.0;
  }
  return inside ? 0.0 : least;
}

/// Result of a test with the circle around the body, which needs no heading.
enum class Rough { kOutside, kInside, kNear };

Rough roughly(const AreaShape& area, Vec2 centre, double radius) {
  const double from_axis = std::abs(centre.y);
  if (centre.x >= area.reach() + radius || from_axis >= area.half_width + radius) return Rough::kOutside;
  if (centre.x <= area.depth - radius && from_axis <= area.half_width - radius) return Rough::kInside;
  return Rough::kNear;
}

bool countsExactly(const AreaShape& area, const AreaBody& body, BodyPart part) {
  switch (part) {
    case BodyPart::kAnyPart:
      return overlaps(area, body);
    case BodyPart::kHalf:
      return shareInside(area, body) > 0.5;
    case BodyPart::kCentre:
      break;
  }
  return contains(area, body.centre);
}

}  // namespace

AreaBody intoGoalFrame(const FieldGeometry& field, Side side, const RobotModel& robot, const Pose2& pose) {
  const Vec2 axis = math::unit(pose.heading);
  return {intoGoalFrame(field, side, pose.position), side == Side::kLeft ? axis : -axis, robot.length / 2,
          robot.width / 2};
}

bool overlaps(const AreaShape& area, const AreaBody& body) {
  const Polygon polygon = polygonOf(body);
  if (areaOf(inStraightPart(area, polygon)) > 0.0) return true;
  if (area.arc_radius <= 0.0) return false;
  const Polygon front = inFront(area, polygon);
  return front.size >= 3 &&
         squaredDistance(front, {area.arc_centre, 0.0}) < area.arc_radius * area.arc_radius;
}

double shareInside(const AreaShape& area, const AreaBody& body) {
  const Polygon polygon = polygonOf(body);
  double inside = areaOf(inStraightPart(area, polygon));
  if (area.arc_radius > 0.0) {
    inside += areaWithDisc(inFront(area, polygon), {area.arc_centre, 0.0}, area.arc_radius);
  }
  return inside / (4 * body.half_length * body.half_width);
}

bool counts(const AreaShape& area, const AreaBody& body, BodyPart part) {
  switch (roughly(area, body.centre, norm({body.half_length, body.half_width}))) {
    case Rough::kOutside:
      return false;
    case Rough::kInside:
      return true;
    case Rough::kNear:
      break;
  }
  return countsExactly(area, body, part);
}

AreaSetup areaSetup(const FieldGeometry& field, const AreaRules& rules) {
  const AreaShape goal_area = goalAreaOf(field, rules.arc), big_area = bigAreaOf(field);
  return {goal_area, grown(goal_area, rules.hysteresis), big_area, grown(big_area, rules.hysteresis)};
}

namespace {

/// Counts ball and robots at one goal.
struct GoalCounter {
  const FieldGeometry& field;
  const RobotModel& robot;
  const AreaRules& rules;
  const AreaSetup& areas;
  Side side;

  bool inside(const AreaShape& area, const Pose2& pose, BodyPart part) const {
    const Vec2 centre = intoGoalFrame(field, side, pose.position);
    const Rough rough = roughly(area, centre, norm({robot.length / 2, robot.width / 2}));
    if (rough != Rough::kNear) return rough == Rough::kInside;
    if (part == BodyPart::kCentre) return contains(area, centre);
    return countsExactly(area, intoGoalFrame(field, side, robot, pose), part);
  }

  void add(std::size_t i, const Pose2& pose, bool attacks, const GoalAreaReport& before,
           GoalAreaReport& report) const {
    const RobotSet set = RobotSet{1} << i;
    const BodyPart part = attacks ? rules.attackers_part : rules.defenders_part;
    const bool was = ((attacks ? before.attackers : before.defenders) & set) != 0;
    if (inside(was ? areas.goal_area_grown : areas.goal_area, pose, part)) {
      (attacks ? report.attackers : report.defenders) |= set;
    }
    if (areas.big_area.half_width <= 0.0) return;
    const bool was_big = ((attacks ? before.big_attackers : before.big_defenders) & set) != 0;
    if (inside(was_big ? areas.big_area_grown : areas.big_area, pose, part)) {
      (attacks ? report.big_attackers : report.big_defenders) |= set;
    }
  }
};

}  // namespace

AreaReport reportAreas(const MatchView& view, const FieldGeometry& field, const RobotModel& robot,
                       const AreaRules& rules, Side blue_side, const AreaReport& before) {
  const AreaSetup areas = areaSetup(field, rules);
  const double nearest = std::max(areas.goal_area_grown.reach(), areas.big_area_grown.depth) +
                         norm({robot.length / 2, robot.width / 2});
  const double near_x = field.length / 2 - nearest;  // bodies nearer to the centre are in no area
  AreaReport report;
  const Vec2 ball = view.ball.position;
  if (std::abs(ball.x) >= near_x) {
    const Side side = ball.x < 0.0 ? Side::kLeft : Side::kRight;
    const std::size_t at = static_cast<std::size_t>(side);
    const Vec2 place = intoGoalFrame(field, side, ball);
    report[at].ball = contains(before[at].ball ? areas.goal_area_grown : areas.goal_area, place);
    report[at].ball_in_big = contains(before[at].ball_in_big ? areas.big_area_grown : areas.big_area, place);
  }
  const std::size_t count = std::min({view.robots.size(), view.ids.size(), kMostRobots});
  for (std::size_t i = 0; i < count; ++i) {
    const Pose2& pose = view.robots[i].pose;
    if (std::abs(pose.position.x) < near_x) continue;
    const Side side = pose.position.x < 0.0 ? Side::kLeft : Side::kRight;
    const Side own = view.ids[i].team == TeamId::kBlue ? blue_side : opposite(blue_side);
    const std::size_t at = static_cast<std::size_t>(side);
    GoalCounter{field, robot, rules, areas, side}.add(i, pose, own != side, before[at], report[at]);
  }
  return report;
}

}  // namespace fulbito
