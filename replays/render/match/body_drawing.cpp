#include "replays/render/match/body_drawing.hpp"

#include <algorithm>
#include <array>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kCut = 0.16;    // of the shorter side: part cut off each corner
constexpr double kBadge = 0.29;  // of the shorter side: radius of the mark
// Factor of a diamond's radius, because it has less room for a number than a disc.
constexpr double kDiamond = 1.24;
constexpr double kLeastNumber = 6.0, kSmallNumber = 8.0;  // [px] numbers below the first are not drawn

/// A robot's frame on the canvas: x ahead, y to its left, in units of half the body's length and width.
class BodyFrame {
 public:
  BodyFrame(const FieldView& view, const Pose2& pose, double length, double width)
      : view_(view), pose_(pose), ahead_(math::unit(pose.heading)), half_{length / 2, width / 2} {}

  Vec2 at(double x, double y) const {
    return view_.at(pose_.position + outOfFrame(ahead_, {x * half_.x, y * half_.y}));
  }
  /// The body's outline with cut corners, shrunk by `inset` [px].
  std::array<Vec2, 8> outline(double inset) const {
    const double ix = inset / view_.px(half_.x), iy = inset / view_.px(half_.y);
    const double cut = kCut * 2 * std::min(half_.x, half_.y) + 0.41 * inset / view_.pixels_per_metre;
    const double x = 1 - ix, y = 1 - iy, cx = cut / half_.x - ix, cy = cut / half_.y - iy;
    return {at(x, y - cy),   at(x - cx, y),   at(-x + cx, y), at(-x, y - cy),
            at(-x, -y + cy), at(-x + cx, -y), at(x - cx, -y), at(x, -y + cy)};
  }
  std::array<Vec2, 4> rectangle(double x0, double y0, double x1, double y1) const {
    return {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
  }

 private:
  const FieldView& view_;
  const Pose2& pose_;
  Vec2 ahead_;
  Vec2 half_;  ///< half length and width of the body [m]
};

}  // namespace

void drawTeamMark(Canvas& canvas, Vec2 centre, double size, TeamId team, Colour colour) {
  if (team == TeamId::kBlue) {
    canvas.fillCircle(centre, size, colour);
    return;
  }
  const std::array<Vec2, 4> diamond{centre + Vec2{size, 0}, centre + Vec2{0, size}, centre - Vec2{size, 0},
                                    centre - Vec2{0, size}};
  canvas.fillConvex(diamond, colour);
}

double markFactor(TeamId team) { return team == TeamId::kBlue ? 1.0 : kDiamond; }

const TeamColours& coloursOf(std::optional<RobotId> id, const MatchStyle& style) {
  return id ? style.teams[indexOf(id->team)] : style.lone;
}

RobotShape shapeOf(const FieldView& view, const RobotModel& robot, const Pose2& pose) {
  const BodyFrame frame(view, pose, robot.length, robot.width);
  const double side = view.px(std::min(robot.length, robot.width)), edge = std::max(1.0, 0.045 * side);
  RobotShape shape{};
  shape.edge = frame.outline(0.0);
  shape.body = frame.outline(edge);
  shape.shadow = shape.edge;
  for (Vec2& p : shape.shadow) p = p + Vec2{0.03, 0.06} * side;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const double y = i == 0 ? -1.0 : 1.0;
    shape.wheels[i] = frame.rectangle(-0.46, y * 0.98, 0.46, y * 0.8);
  }
  shape.nose = {frame.at(0.88, 0.36), frame.at(0.88, -0.36), frame.at(0.64, -0.6), frame.at(0.64, 0.6)};
  shape.badge = frame.at(-0.12, 0.0);
  shape.badge_size = kBadge * side;
  const double digit = std::max(0.42 * side, std::min(kSmallNumber, 0.52 * side));
  shape.digit_size = digit < kLeastNumber ? 0.0 : digit;
  return shape;
}

void drawRobot(const FieldView& view, const RobotModel& robot, const Pose2& pose, std::optional<RobotId> id,
               const MatchStyle& style) {
  const TeamColours& colours = coloursOf(id, style);
  const RobotShape shape = shapeOf(view, robot, pose);
  view.canvas.fillConvex(shape.shadow, style.shadow);
  view.canvas.fillConvex(shape.edge, colours.edge);
  view.canvas.fillConvex(shape.body, colours.body);
  for (const auto& wheel : shape.wheels) view.canvas.fillConvex(wheel, style.wheel);
  view.canvas.fillConvex(shape.nose, colours.nose);
  if (!id) return;
  drawTeamMark(view.canvas, shape.badge, shape.badge_size * markFactor(id->team), id->team, colours.badge);
  if (shape.digit_size == 0.0) return;
  view.canvas.label(shape.badge + Vec2{0.0, kDigitDrop * shape.digit_size}, std::to_string(id->number),
                    {shape.digit_size, colours.digit, TextAlign::kCentre, true});
}

void drawMatchBall(const FieldView& view, Vec2 place, double radius, const MatchStyle& style) {
  const Vec2 centre = view.at(place);
  const double r = std::max(2.0, view.px(radius)), edge = std::max(0.8, 0.1 * r);
  view.canvas.fillCircle(centre + Vec2{0.1, 0.22} * r, r, style.shadow);
  view.canvas.fillCircle(centre, r, style.ball_edge);
  view.canvas.fillCircle(centre, r - edge, style.ball);
  view.canvas.fillCircle(centre - Vec2{0.28, 0.3} * r, 0.26 * r, style.ball_light);
}

}  // namespace fulbito
