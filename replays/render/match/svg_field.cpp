#include "replays/render/match/svg_field.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"
#include "replays/render/field/field_drawing.hpp"

namespace fulbito {
namespace {

/// A colour as SVG attribute `name`, with an opacity attribute if it is not opaque.
std::string paint(const char* name, Colour c) {
  std::string text = fmt::format("{}=\"#{:02x}{:02x}{:02x}\"", name, c.r, c.g, c.b);
  if (c.a != 255) text += fmt::format(" {}-opacity=\"{:.3f}\"", name, c.a / 255.0);
  return text;
}

std::string pointList(std::span<const Vec2> points) {
  std::string text;
  for (const Vec2 p : points) text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x, p.y);
  return text;
}

/// Draws field lines, with coordinates in metres.
class LinePen {
 public:
  LinePen(SvgText& svg, const MatchPlan& plan, Colour colour)
      : svg_(svg), plan_(plan), colour_(colour), thickness_(std::max(1.4, 0.004 * plan.pixels_per_metre)) {}

  void through(std::vector<Vec2> points) const {
    for (Vec2& p : points) p = pixelOf(plan_, p);
    svg_.polyline(points, thickness_, colour_);
  }
  void circle(Vec2 centre, double radius) const {
    svg_.ring(pixelOf(plan_, centre), radius * plan_.pixels_per_metre, thickness_, colour_);
  }
  void dot(Vec2 centre) const { svg_.circle(pixelOf(plan_, centre), 1.8 * thickness_, colour_); }
  /// Draws the arc of a goal area from one point to the other, bulging by `depth` [m].
  void arc(Vec2 from, Vec2 to, double depth, bool sweep) const {
    const double half = distance(from, to) / 2, radius = (half * half + depth * depth) / (2 * depth);
    const Vec2 a = pixelOf(plan_, from), b = pixelOf(plan_, to);
    svg_.raw(
        fmt::format("<path d=\"M{:.2f},{:.2f}A{:.2f},{:.2f} 0 0 {} {:.2f},{:.2f}\" fill=\"none\" {} "
                    "stroke-width=\"{:.2f}\"/>",
                    a.x, a.y, radius * plan_.pixels_per_metre, radius * plan_.pixels_per_metre, sweep ? 1 : 0,
                    b.x, b.y, paint("stroke", colour_), thickness_));
  }

 private:
  SvgText& svg_;
  const MatchPlan& plan_;
  Colour colour_;
  double thickness_;
};

void svgHalf(const LinePen& pen, const FieldGeometry& field, double side) {
  const double x = side * field.length / 2, goal = field.goal_width / 2;
  const auto area = [&](double width, double depth) {
    if (!(width > 0.0 && depth > 0.0)) return;
    const double front = x - side * depth, half = width / 2;
    pen.through({{x, -half}, {front, -half}, {front, half}, {x, half}});
  };
  if (field.hasGoals()) pen.through({{x, -goal}, {x, goal}});
  area(field.goal_area_width, field.goal_area_depth);
  area(field.big_area_width, field.big_area_depth);
  if (field.goal_area_arc_width > 0.0 && field.goal_area_arc_depth > 0.0) {
    const double front = x - side * field.goal_area_depth, half = field.goal_area_arc_width / 2;
    pen.arc({front, half}, {front, -half}, field.goal_area_arc_depth, side < 0.0);
  }
  if (field.penalty_mark > 0.0) pen.dot({side * field.penalty_mark, 0.0});
  const Vec2 mark = field.free_ball_mark;
  if (!(mark.x > 0.0 && mark.y > 0.0)) return;
  constexpr double kArm = 0.0125;  // [m]
  for (const double y : {mark.y, -mark.y}) {
    const Vec2 p{side * mark.x, y};
    pen.through({p - Vec2{kArm, 0}, p + Vec2{kArm, 0}});
    pen.through({p - Vec2{0, kArm}, p + Vec2{0, kArm}});
  }
}

void svgWalls(SvgText& svg, const MatchPlan& plan, const FieldGeometry& field, const FieldColours& colours) {
  const double x = field.length / 2, y = field.width / 2, wall = kDrawnWall;
  const double g = field.goal_width / 2, d = field.goal_depth, scale = plan.pixels_per_metre;
  const auto box = [&](double left, double top, double width, double height, Colour colour) {
    svg.rectangle(pixelOf(plan, {left, top}), width * scale, height * scale, colour);
  };
  box(-x - wall, y + wall, field.length + 2 * wall, field.width + 2 * wall, colours.wall);
  if (field.hasGoals()) {
    box(-x - d - wall, g + wall, field.length + 2 * (d + wall), field.goal_width + 2 * wall, colours.wall);
  }
  std::vector<Vec2> contour;
  for (const Vec2 p : innerContour(field)) contour.push_back(pixelOf(plan, p));
  svg.polygon(contour, colours.floor);
  if (!field.hasGoals()) return;
  box(-x - d, g, d, field.goal_width, colours.left_goal);
  box(x, g, d, field.goal_width, colours.right_goal);
}

}  // namespace

void SvgText::rectangle(Vec2 corner, double width, double height, Colour fill) {
  raw(fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>", corner.x,
                  corner.y, width, height, paint("fill", fill)));
}

void SvgText::polygon(std::span<const Vec2> points, Colour fill) {
  raw(fmt::format("<polygon points=\"{}\" {}/>", pointList(points), paint("fill", fill)));
}

void SvgText::circle(Vec2 centre, double radius, Colour fill) {
  raw(fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>", centre.x, centre.y, radius,
                  paint("fill", fill)));
}

void SvgText::ring(Vec2 centre, double radius, double thickness, Colour stroke) {
  raw(fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\" {} stroke-width=\"{:.2f}\"/>", centre.x,
      centre.y, radius, paint("stroke", stroke), thickness));
}

void SvgText::polyline(std::span<const Vec2> points, double thickness, Colour stroke) {
  if (points.size() < 2) return;
  raw(
      fmt::format("<polyline points=\"{}\" fill=\"none\" {} stroke-width=\"{:.2f}\" stroke-linecap=\"round\" "
                  "stroke-linejoin=\"round\"/>",
                  pointList(points), paint("stroke", stroke), thickness));
}

void SvgText::text(Vec2 baseline, const std::string& utf8, const TextStyle& style) {
  if (utf8.empty()) return;
  const char* anchor = style.align == TextAlign::kLeft     ? "start"
                       : style.align == TextAlign::kCentre ? "middle"
                                                           : "end";
  // Text sizes of the canvas refer to the font's em square, as in SVG.
  raw(fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" text-anchor=\"{}\"{} {}>{}</text>",
                  baseline.x, baseline.y, style.size, anchor, style.bold ? " font-weight=\"bold\"" : "",
                  paint("fill", style.colour), escapedXml(utf8)));
}

void svgField(SvgText& svg, const MatchPlan& plan, const FieldGeometry& field, const FieldColours& colours) {
  svgWalls(svg, plan, field, colours);
  if (!isPitch(field)) return;
  const LinePen pen(svg, plan, colours.line);
  const double y = field.width / 2;
  pen.through({{0.0, -y}, {0.0, y}});
  pen.circle({0.0, 0.0}, field.centre_circle_radius);
  pen.dot({0.0, 0.0});
  svgHalf(pen, field, 1.0);
  svgHalf(pen, field, -1.0);
  std::vector<Vec2> contour = innerContour(field);
  contour.push_back(contour.front());
  pen.through(std::move(contour));
}

}  // namespace fulbito
