#include "replays/render/match/overlay_drawing.hpp"

#include <algorithm>
#include <array>

#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/match/body_drawing.hpp"

namespace fulbito {
namespace {

constexpr double kLongestText = 0.6;  // share of the picture's width

/// Draws a text centred at its place, with an outline in the floor's colour that keeps it readable over
/// lines.
void drawWord(Canvas& canvas, Vec2 place, const std::string& text, const TextStyle& ink, Colour floor) {
  const Vec2 baseline = place + Vec2{0.0, 0.33 * ink.size};
  const double seam = std::max(1.0, 0.09 * ink.size);
  TextStyle under = ink;
  under.colour = withAlpha(floor, 190);
  for (const Vec2 off : {Vec2{seam, 0}, Vec2{-seam, 0}, Vec2{0, seam}, Vec2{0, -seam}}) {
    canvas.label(baseline + off, text, under);
  }
  canvas.label(baseline, text, ink);
}

/// Draws a plate with round ends.
void drawPlate(Canvas& canvas, Vec2 corner, double width, double height, Colour colour) {
  const std::array<Vec2, 2> middle{corner + Vec2{height / 2, height / 2},
                                   corner + Vec2{width - height / 2, height / 2}};
  canvas.polyline(middle, height, colour);
}

}  // namespace

TrailLook lookOf(const RecordedBody& body, const MatchPictureSpec& spec) {
  const MatchStyle& style = styleOf(spec.theme);
  if (body.kind == BodyKind::kBall) return {0.0, 1.5 * spec.ball.radius, withAlpha(style.ball, 200)};
  const Colour colour = body.id ? style.teams[indexOf(body.id->team)].body : style.lone.body;
  return {0.0, 0.32 * spec.robot.width, withAlpha(colour, 150)};
}

void drawTrails(const FieldView& view, const MatchPictureSpec& spec, const std::vector<BodyTrail>& trails) {
  std::vector<Vec2> line;
  for (const bool balls : {false, true}) {
    for (const BodyTrail& trail : trails) {
      if (trail.body >= spec.bodies.size()) continue;
      const RecordedBody& body = spec.bodies[trail.body];
      if ((body.kind == BodyKind::kBall) != balls) continue;
      line.clear();
      for (const Vec2 p : trail.points) line.push_back(view.at(p));
      const TrailLook look = lookOf(body, spec);
      const bool thick = balls || !body.id;  // the important bodies: the ball, or a trial's robot
      if (trail.fading) {
        view.canvas.fadingLine(line, view.px(look.first), view.px(look.last), look.colour);
      } else {
        view.canvas.polyline(
            line, std::max(1.0, (thick ? 2.2 : 1.4) * view.unit),
            withAlpha(look.colour, static_cast<std::uint8_t>((thick ? 190.0 : 130.0) *
                                                             std::clamp(trail.strength, 0.0, 1.0))));
      }
    }
  }
}

Colour inkOf(const RecordedDrawing& drawing, const MatchPictureSpec& spec) {
  const MatchStyle& style = styleOf(spec.theme);
  return spec.layout ? style.lone.ink : style.teams[indexOf(drawing.team)].ink;
}

DrawnWords wordsOf(const FieldView& view, const MatchPlan& plan, const RecordedDrawing& drawing) {
  const double size = plan.text(12);
  const std::string text = fitted(view.canvas, drawing.text, size, kLongestText * plan.width);
  const double side = view.canvas.textWidth(text, size) / 2 + size / 4;
  const Vec2 place = view.at(drawing.from);
  return {text, {std::clamp(place.x, side, std::max(side, plan.width - side)), place.y}, size};
}

void drawDrawings(const FieldView& view, const MatchPlan& plan, const MatchPictureSpec& spec,
                  std::span<const RecordedDrawing> drawings) {
  const double thickness = std::max(1.0, 1.6 * plan.unit);
  for (const RecordedDrawing& drawing : drawings) {
    const Colour colour = inkOf(drawing, spec);
    const Vec2 from = view.at(drawing.from);
    if (drawing.kind == RecordedDrawing::Kind::kLine) {
      view.canvas.line(from, view.at(drawing.to), thickness, colour);
    } else if (drawing.kind == RecordedDrawing::Kind::kCircle) {
      view.canvas.circle(from, view.px(drawing.radius), thickness, colour);
    }
    if (drawing.text.empty()) continue;
    const DrawnWords words = wordsOf(view, plan, drawing);
    drawWord(view.canvas, words.centre, words.text, {words.size, colour, TextAlign::kCentre, false},
             styleOf(spec.theme).field.floor);
  }
}

void drawBanner(Canvas& canvas, const MatchPlan& plan, const MatchBanner& banner, const MatchStyle& style) {
  if (banner.title.empty()) return;
  const double u = plan.unit, height = std::max(38 * u, 19.0), size = plan.text(18), small = plan.text(14);
  const double mark = 0.24 * height, gap = 0.36 * height, widest = kLongestText * plan.width;
  const TextStyle bold{size, style.text, TextAlign::kLeft, true};
  const TextStyle plain{small, style.dim_text, TextAlign::kLeft, false};
  const std::string title = fitted(canvas, banner.title, size, widest / 2);
  const std::string detail = fitted(canvas, banner.detail, small, widest / 2);
  const double title_width = canvas.labelWidth(title, bold), detail_width = canvas.labelWidth(detail, plain);
  const double marks = banner.team ? 2 * mark + gap : 0.0;
  const double width =
      2 * gap + marks + title_width + (detail.empty() ? 0.0 : detail_width + gap) + 0.3 * height;
  const Vec2 corner{std::round((plan.width - width) / 2),
                    std::round(plan.board + plan.margin + 0.9 * height)};
  drawPlate(canvas, corner - Vec2{1.2, 1.2} * std::max(u, 0.6), width + 2.4 * std::max(u, 0.6),
            height + 2.4 * std::max(u, 0.6), style.rule);
  drawPlate(canvas, corner, width, height, style.banner);
  Vec2 pen = corner + Vec2{gap + 0.15 * height, height / 2};
  if (banner.team) {
    drawTeamMark(canvas, pen + Vec2{mark, 0}, mark * (*banner.team == TeamId::kBlue ? 1.0 : 1.2),
                 *banner.team, style.teams[indexOf(*banner.team)].body);
    pen.x += marks;
  }
  const double baseline = std::round(pen.y + 0.36 * size);
  canvas.label({std::round(pen.x), baseline}, title, bold);
  canvas.label({std::round(pen.x + title_width + gap), baseline}, detail, plain);
}

}  // namespace fulbito
