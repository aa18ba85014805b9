#include "replays/render/field/field_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

constexpr double kLine = 0.004;  // [m] width of white lines

double lineThickness(const FieldView& view) { return std::max(1.4, view.px(kLine)); }

void fillWorldRectangle(const FieldView& view, double left, double top, double width, double height,
                        Colour colour) {
  view.canvas.fillRectangle(view.at({left, top}), view.px(width), view.px(height), colour);
}

void drawBorder(const FieldView& view, const FieldGeometry& field, const FieldColours& colours) {
  std::vector<Vec2> contour;
  for (Vec2 p : innerContour(field)) contour.push_back(view.at(p));
  contour.push_back(contour.front());
  view.canvas.polyline(contour, lineThickness(view), colours.line);
}

/// Draws the three lines of an area in front of the goal line; `x` is the goal line's.
void drawArea(const FieldView& view, double x, double front, double half_width, Colour line) {
  const std::array<Vec2, 4> lines{view.at({x, -half_width}), view.at({front, -half_width}),
                                  view.at({front, half_width}), view.at({x, half_width})};
  view.canvas.polyline(lines, lineThickness(view), line);
}

/// Draws the arc of the goal area: a circle through the ends of its chord on the front line and its foremost
/// point.
void drawAreaArc(const FieldView& view, const FieldGeometry& field, double front, double side, Colour line) {
  constexpr int kPieces = 24;
  const double half = field.goal_area_arc_width / 2, depth = field.goal_area_arc_depth;
  const double radius = (half * half + depth * depth) / (2 * depth);
  const double opening = math::atan2(half, radius - depth);
  const Vec2 centre{front + side * (radius - depth), 0.0};
  std::vector<Vec2> arc;
  for (int i = 0; i <= kPieces; ++i) {
    const Vec2 p = math::unit(opening * (2.0 * i / kPieces - 1.0)) * radius;
    arc.push_back(view.at(centre + Vec2{-side * p.x, p.y}));
  }
  view.canvas.polyline(arc, lineThickness(view), line);
}

/// Draws the crosses at the free-ball marks of one half.
void drawFreeBallMarks(const FieldView& view, Vec2 mark, double side, Colour line) {
  constexpr double kArm = 0.0125;  // [m]
  for (double y : {mark.y, -mark.y}) {
    const Vec2 p{side * mark.x, y};
    view.canvas.line(view.at(p - Vec2{kArm, 0}), view.at(p + Vec2{kArm, 0}), lineThickness(view), line);
    view.canvas.line(view.at(p - Vec2{0, kArm}), view.at(p + Vec2{0, kArm}), lineThickness(view), line);
  }
}

/// Draws the lines of the right half, or of the left one if `side` is -1.
void drawHalf(const FieldView& view, const FieldGeometry& field, double side, const FieldColours& colours) {
  const double x = side * field.length / 2, thickness = lineThickness(view);
  const double g = field.goal_width / 2, area = field.goal_area_width / 2;
  if (field.hasGoals()) view.canvas.line(view.at({x, -g}), view.at({x, g}), thickness, colours.line);
  if (area > 0.0 && field.goal_area_depth > 0.0) {
    const double front = x - side * field.goal_area_depth;
    drawArea(view, x, front, area, colours.line);
    if (field.goal_area_arc_width > 0.0 && field.goal_area_arc_depth > 0.0) {
      drawAreaArc(view, field, front, side, colours.line);
    }
  }
  if (field.big_area_width > 0.0 && field.big_area_depth > 0.0) {
    drawArea(view, x, x - side * field.big_area_depth, field.big_area_width / 2, colours.line);
  }
  if (field.free_ball_mark.x > 0.0 && field.free_ball_mark.y > 0.0) {
    drawFreeBallMarks(view, field.free_ball_mark, side, colours.line);
  }
  if (field.penalty_mark > 0.0) {
    view.canvas.fillCircle(view.at({side * field.penalty_mark, 0.0}), 1.8 * thickness, colours.line);
  }
}

/// Draws the two seams of a tennis ball, as arcs around points outside of it.
void drawSeams(const FieldView& view, Vec2 centre, double radius, double turn) {
  constexpr int kPieces = 14;
  // In radii, so that the arcs end on the ball's rim.
  const double away = 1.25, arc = 0.85, half_opening = 0.86;
  for (double side : {0.0, math::kPi}) {
    const Vec2 middle = centre + math::unit(turn + side) * (away * radius);
    std::vector<Vec2> seam;
    for (int i = 0; i <= kPieces; ++i) {
      const double angle = turn + side + math::kPi + half_opening * (2.0 * i / kPieces - 1.0);
      seam.push_back(view.at(middle + math::unit(angle) * (arc * radius)));
    }
    view.canvas.polyline(seam, std::max(1.0, view.px(0.1 * radius)), theme::kSeam);
  }
}

void drawBall(const FieldView& view, Vec2 position, double radius, Colour colour) {
  const Vec2 centre = view.at(position);
  const double r = view.px(radius);
  view.canvas.fillCircle(centre, r, darkened(colour, 0.45));
  view.canvas.fillCircle(centre, 0.94 * r, darkened(colour, 0.12));
  view.canvas.fillCircle(centre - Vec2{0.1, 0.1} * r, 0.8 * r, colour);
  drawSeams(view, position, 0.94 * radius, 0.6);
}

void drawBox(const FieldView& view, const ObstacleSpec& box, Colour colour) {
  const auto outline = [&](double share) {
    std::array<Vec2, 4> corners = bodyCorners(box.pose, share * box.length, share * box.width);
    for (Vec2& p : corners) p = view.at(p);
    return corners;
  };
  view.canvas.fillPolygon(outline(1.0), darkened(colour, 0.45));
  view.canvas.fillPolygon(outline(0.9), colour);
  view.canvas.fillPolygon(outline(0.6), darkened(colour, 0.14));
}

void drawObstaclePath(const FieldView& view, const ObstacleSpec& obstacle, Colour colour) {
  std::vector<Vec2> path;
  path.reserve(obstacle.path.size() + 1);
  for (Vec2 p : obstacle.path) path.push_back(view.at(p));
  if (obstacle.path_end == PathEnd::kCycle) path.push_back(path.front());
  const double u = view.unit, head = 14 * u;
  drawDashed(view.canvas, path, {9 * u, 5 * u}, 1.6 * u, colour);
  // The path of a cycle ends under the obstacle, so its arrow is drawn at the end of the first segment.
  const std::size_t end = obstacle.path_end == PathEnd::kCycle ? 1 : path.size() - 1;
  drawArrowHead(view.canvas, path[end], unitOr(path[end] - path[end - 1], {}), head, colour);
  if (obstacle.path_end == PathEnd::kBounce) {
    drawArrowHead(view.canvas, path[0], unitOr(path[0] - path[1], {}), head, colour);
  }
}

}  // namespace

FieldColours defaultFieldColours() {
  const Colour goal = darkened(theme::kFloor, 0.3);
  return {theme::kWall, theme::kFloor, goal, goal, theme::kFieldLine};
}

bool isPitch(const FieldGeometry& field) { return field.hasGoals() || field.centre_circle_radius > 0.0; }

void drawFloorAndWalls(const FieldView& view, const FieldGeometry& field, const FieldColours& colours) {
  const double x = field.length / 2, y = field.width / 2, wall = kDrawnWall;
  const double g = field.goal_width / 2, d = field.goal_depth;
  fillWorldRectangle(view, -x - wall, y + wall, field.length + 2 * wall, field.width + 2 * wall,
                     colours.wall);
  if (field.hasGoals()) {
    fillWorldRectangle(view, -x - d - wall, g + wall, field.length + 2 * (d + wall),
                       field.goal_width + 2 * wall, colours.wall);
    fillWorldRectangle(view, -x - d, g, d, field.goal_width, colours.left_goal);
    fillWorldRectangle(view, x, g, d, field.goal_width, colours.right_goal);
  }
  fillWorldRectangle(view, -x, y, field.length, field.width, colours.floor);
  if (!(field.corner > 0.0)) return;
  for (Vec2 s : {Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}, Vec2{1, -1}}) {
    // The triangle extends a little into the walls, so that no gap shows.
    const double seam = 0.3 * wall, leg = field.corner + seam;
    const std::array<Vec2, 3> triangle{view.at({s.x * (x + seam), s.y * (y + seam)}),
                                       view.at({s.x * (x - leg), s.y * (y + seam)}),
                                       view.at({s.x * (x + seam), s.y * (y - leg)})};
    view.canvas.fillPolygon(triangle, colours.wall);
  }
}

void drawFieldLines(const FieldView& view, const FieldGeometry& field, const FieldColours& colours) {
  const double thickness = lineThickness(view), y = field.width / 2;
  view.canvas.line(view.at({0, -y}), view.at({0, y}), thickness, colours.line);
  view.canvas.circle(view.at({0, 0}), view.px(field.centre_circle_radius), thickness, colours.line);
  view.canvas.fillCircle(view.at({0, 0}), 1.8 * thickness, colours.line);
  drawHalf(view, field, 1.0, colours);
  drawHalf(view, field, -1.0, colours);
  drawBorder(view, field, colours);
}

void drawField(const FieldView& view, const FieldGeometry& field, const FieldColours& colours) {
  drawFloorAndWalls(view, field, colours);
  if (isPitch(field)) drawFieldLines(view, field, colours);
}

Colour obstacleColour(const ObstacleSpec& obstacle) {
  return obstacle.motion == ObstacleMotion::kPushable ? theme::kPushable : theme::kTennisBall;
}

void drawObstacle(const FieldView& view, const ObstacleSpec& obstacle) {
  if (obstacle.motion == ObstacleMotion::kPath && obstacle.path.size() > 1) {
    drawObstaclePath(view, obstacle, obstacleColour(obstacle));
  }
  drawObstacleBody(view, obstacle);
}

void drawObstacleBody(const FieldView& view, const ObstacleSpec& obstacle) {
  const Colour colour = obstacleColour(obstacle);
  if (obstacle.shape == ObstacleShape::kDisc) {
    drawBall(view, obstacle.pose.position, obstacle.radius, colour);
  } else {
    drawBox(view, obstacle, colour);
  }
}

void drawStart(const FieldView& view, const RobotModel& robot, const Pose2& start) {
  std::array<Vec2, 4> body = bodyCorners(start, robot.length, robot.width);
  for (Vec2& p : body) p = view.at(p);
  view.canvas.fillPolygon(body, theme::kWall);
  const std::array<Vec2, 5> outline{body[0], body[1], body[2], body[3], body[0]};
  view.canvas.polyline(outline, 1.8 * view.unit, theme::kMarker);
  const Vec2 ahead = math::unit(start.heading);
  const Vec2 nose = view.at(start.position + ahead * (0.33 * robot.length));
  drawArrowHead(view.canvas, nose, {ahead.x, -ahead.y}, view.px(0.6 * robot.length), theme::kMarker);
}

void drawGoal(const FieldView& view, const Layout& layout) { drawGoal(view, layout, theme::kMarker); }

void drawGoal(const FieldView& view, const Layout& layout, Colour colour) {
  const Vec2 goal = view.at(layout.goal);
  const double u = view.unit, radius = view.px(layout.goal_tolerance);
  view.canvas.fillCircle(goal, radius, withAlpha(colour, 46));
  view.canvas.circle(goal, radius, 1.6 * u, colour);
  view.canvas.fillCircle(goal, 3.2 * u, colour);
  if (!layout.goal_heading) return;
  const Vec2 world = math::unit(*layout.goal_heading), along{world.x, -world.y};
  const Vec2 tip = goal + along * (radius + 26 * u);
  view.canvas.line(goal, tip - along * (6 * u), 2.2 * u, colour);
  drawArrowHead(view.canvas, tip, along, 12 * u, colour);
}

void drawDashed(Canvas& canvas, std::span<const Vec2> points, Dashes dashes, double thickness,
                Colour colour) {
  std::vector<Vec2> dash;
  const auto finish = [&] {
    if (dash.size() > 1) canvas.polyline(dash, thickness, colour);
    dash.clear();
  };
  double walked = dashes.period - dashes.phase;  // [px] since the begin of the last dash
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 a = points[i - 1], b = points[i];
    const double length = distance(a, b);
    if (!(length < 1e6)) {
      finish();
      continue;
    }
    for (double s = 0.0; s < length;) {
      if (walked >= dashes.period) walked -= dashes.period;
      const bool on = walked < dashes.on;
      const double boundary = on ? dashes.on : dashes.period;
      if (on && dash.empty()) dash.push_back(a + (b - a) * (s / length));
      if (boundary - walked > length - s) {
        walked += length - s;
        s = length;
      } else {
        s += boundary - walked;
        walked = boundary;
      }
      if (on) dash.push_back(a + (b - a) * (std::min(s, length) / length));
      if (walked == dashes.on) finish();
    }
  }
  finish();
}

void drawArrowHead(Canvas& canvas, Vec2 tip, Vec2 direction, double size, Colour colour) {
  const Vec2 back = tip - direction * size, side = perp(direction) * (0.42 * size);
  const std::array<Vec2, 4> head{tip, back + side, back + direction * (0.25 * size), back - side};
  canvas.fillPolygon(head, colour);
}

std::array<Vec2, 4> bodyCorners(const Pose2& pose, double length, double width) {
  const Vec2 ahead = math::unit(pose.heading) * (length / 2);
  const Vec2 left = perp(math::unit(pose.heading)) * (width / 2);
  const Vec2 p = pose.position;
  return {p + ahead + left, p - ahead + left, p - ahead - left, p + ahead - left};
}

}  // namespace fulbito
