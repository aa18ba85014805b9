#include "experiments/paper_report/scene_picture.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/canvas/text_wrap.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_drawing.hpp"

namespace fulbito {
namespace {

// In units of `Plan::unit`.
constexpr double kMargin = 22, kTitle = 22, kText = 15, kLine = 21, kSample = 30, kTrail = 2.5;
constexpr int kOutlines = 24;  // greatest number of outlines per body in the picture of a whole scene

/// A row of the legend.
struct LegendEntry {
  std::string text;
  Colour colour;
  bool dashed;
};

/// Layout of the picture [px].
struct Plan {
  double unit;
  Vec2 size;
  Vec2 field;  ///< upper left corner
  Vec2 field_size;
  double scale;  ///< [px/m]
  std::vector<std::string> caption;
  std::vector<LegendEntry> legend;
};

/// The names of the bodies' colours: roles if the scene has them, otherwise the bodies themselves.
const std::vector<std::string>& namesOf(const ReportScene& scene) {
  return scene.roles.names.empty() ? scene.labels : scene.roles.names;
}

Colour pathColour(const ReportScene& scene, std::size_t path) {
  return seriesColour(namesOf(scene).size() + path);
}

std::vector<LegendEntry> legendOf(const ReportScene& scene) {
  std::vector<LegendEntry> legend;
  const std::vector<std::string>& names = namesOf(scene);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) legend.push_back({names[i], seriesColour(i), false});
  }
  for (std::size_t i = 0; i < scene.paths.size(); ++i) {
    if (scene.paths[i].label.empty()) continue;
    legend.push_back({scene.paths[i].label, pathColour(scene, i), scene.paths[i].dashed});
  }
  return legend;
}

Plan makePlan(const Canvas& measure, const ReportScene& scene, double width) {
  Plan plan;
  const FieldGeometry& field = scene.page.field;
  const double goals = field.hasGoals() ? 2 * field.goal_depth : 0.0;
  const Vec2 metres{field.length + goals + 2 * kDrawnWall, field.width + 2 * kDrawnWall};
  // The longer side of the room has the given width, whether the room is tall or wide.
  plan.scale = width / std::max(metres.x, metres.y);
  plan.field_size = metres * plan.scale;
  plan.unit = std::clamp(width / 900.0, 0.75, 2.0);
  const double u = plan.unit;
  plan.legend = legendOf(scene);
  double wide = std::max(plan.field_size.x, 380 * u);
  for (const LegendEntry& entry : plan.legend) {
    wide = std::max(wide, kSample * u + 8 * u + measure.textWidth(entry.text, kText * u));
  }
  if (!scene.caption.empty()) plan.caption = wrapped(measure, scene.caption, kText * u, wide);
  const double top = kMargin * u + (kTitle + 12) * u + kLine * u * static_cast<double>(plan.caption.size());
  plan.field = {kMargin * u + (wide - plan.field_size.x) / 2, top};
  plan.size = {wide + 2 * kMargin * u, top + plan.field_size.y + (kMargin + 8) * u +
                                           kLine * u * static_cast<double>(plan.legend.size())};
  return plan;
}

void drawTexts(Canvas& canvas, const Plan& plan, const ReportScene& scene, double seconds) {
  const double u = plan.unit, left = kMargin * u;
  const std::string clock = scene.isStill() ? "" : fmt::format("{:.1f} s", seconds);
  canvas.text({plan.size.x - left, left + kTitle * u * 0.8}, clock, kText * u, theme::kDimText,
              TextAlign::kRight);
  const double room = plan.size.x - 2 * left - canvas.textWidth(clock, kText * u) - 12 * u;
  canvas.text({left, left + kTitle * u * 0.8}, fitted(canvas, scene.page.title, kTitle * u, room), kTitle * u,
              theme::kText);
  double y = left + (kTitle + 16) * u;
  for (const std::string& line : plan.caption) {
    canvas.text({left, y}, line, kText * u, theme::kDimText);
    y += kLine * u;
  }
  y = plan.field.y + plan.field_size.y + (kMargin + 4) * u;
  for (const LegendEntry& entry : plan.legend) {
    const std::vector<Vec2> sample{{left, y - 5 * u}, {left + kSample * u, y - 5 * u}};
    if (entry.dashed) {
      drawDashed(canvas, sample, {9 * u, 5 * u}, kTrail * u, entry.colour);
    } else {
      canvas.polyline(sample, kTrail * u, entry.colour);
    }
    canvas.text({left + (kSample + 8) * u, y}, entry.text, kText * u, theme::kText);
    y += kLine * u;
  }
}

/// The longest bar of 1, 2 or 5 times a power of ten [m] that takes at most a quarter of `length` [m].
double scaleBar(double length) {
  double bar = 0.01;
  for (const double step : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
    if (step <= length / 4) bar = step;
  }
  return bar;
}

/// Draws a bar with its length below the right end of the field.
void drawScale(Canvas& canvas, const Plan& plan) {
  const double u = plan.unit, bar = scaleBar(plan.field_size.x / plan.scale);
  const Vec2 right = plan.field + plan.field_size + Vec2{0.0, (kMargin - 1) * u};
  const Vec2 left = right - Vec2{bar * plan.scale, 0.0}, tick{0.0, 5 * u};
  canvas.line(left, right, 1.6 * u, theme::kDimText);
  for (const Vec2 end : {left, right}) canvas.line(end - tick, end + tick, 1.6 * u, theme::kDimText);
  canvas.text(left - Vec2{8 * u, -5 * u}, fmt::format("{:g} m", bar), kText * u, theme::kDimText,
              TextAlign::kRight);
}

/// Draws the part of a drawing that belongs on top of the field.
void drawDrawing(const FieldView& view, const RecordedDrawing& drawing) {
  const Colour colour = withAlpha(theme::kDimText, 150);
  switch (drawing.kind) {
    case RecordedDrawing::Kind::kLine:
      view.canvas.line(view.at(drawing.from), view.at(drawing.to), 1.2 * view.unit, colour);
      return;
    case RecordedDrawing::Kind::kCircle:
      view.canvas.circle(view.at(drawing.from), view.px(drawing.radius), 1.2 * view.unit, colour);
      return;
    case RecordedDrawing::Kind::kText:
      view.canvas.text(view.at(drawing.from), drawing.text, 13 * view.unit, theme::kText, TextAlign::kCentre);
      return;
  }
}

void drawDrawings(const FieldView& view, const PageScene& page, Tick tick) {
  // Like the viewer, shows the newest drawings while they are valid.
  Tick newest = -1;
  for (const RecordedDrawing& drawing : page.drawings) {
    if (drawing.tick <= tick) newest = std::max(newest, drawing.tick);
  }
  if (newest < 0 || tick - newest >= page.drawing_ticks) return;
  for (const RecordedDrawing& drawing : page.drawings) {
    if (drawing.tick == newest) drawDrawing(view, drawing);
  }
}

void drawBody(const FieldView& view, const PageBody& body, const Pose2& pose, Colour colour) {
  if (!body.box) {
    view.canvas.fillCircle(view.at(pose.position), view.px(body.radius), colour);
    return;
  }
  std::vector<Vec2> corners;
  for (const Vec2 corner : bodyCorners(pose, body.length, body.width)) corners.push_back(view.at(corner));
  view.canvas.fillConvex(corners, colour);
}

void drawHeading(const FieldView& view, const PageBody& body, const Pose2& pose) {
  if (body.kind != BodyKind::kRobot) return;
  const double reach = body.box ? body.length / 2 : body.radius;
  const Vec2 ahead{math::cos(pose.heading), math::sin(pose.heading)};
  view.canvas.line(view.at(pose.position), view.at(pose.position + ahead * reach), 2 * view.unit,
                   theme::kPage);
}

/// The index of a body's colour: that of its role, or the body's own.
std::size_t colourNumber(const ReportScene& scene, std::size_t body, std::size_t row) {
  return scene.roles.names.empty() ? body : scene.roles.rows[row][body];
}

Colour colourOf(const ReportScene& scene, std::size_t body, std::size_t row) {
  if (!scene.roles.names.empty()) return seriesColour(colourNumber(scene, body, row));
  return scene.page.bodies[body].kind == BodyKind::kObstacle && body >= scene.labels.size()
             ? theme::kTennisBall
             : seriesColour(body);
}

/// Whether a body moves; other bodies have neither a trail nor outlines.
bool moves(const PageScene& page, std::size_t body) {
  const Vec2 first = page.rows.front().poses[body].position;
  return std::any_of(page.rows.begin(), page.rows.end(),
                     [&](const PageRow& row) { return distance(row.poses[body].position, first) > 1e-3; });
}

/// Draws a body's trail. Each piece has the colour that the body has there.
void drawTrail(const FieldView& view, const ReportScene& scene, std::size_t body, std::size_t row) {
  const std::vector<PageRow>& rows = scene.page.rows;
  std::vector<Vec2> piece;
  for (std::size_t r = 0; r <= row; ++r) {
    piece.push_back(view.at(rows[r].poses[body].position));
    if (r < row && colourNumber(scene, body, r + 1) == colourNumber(scene, body, r)) continue;
    view.canvas.polyline(piece, kTrail * view.unit, withAlpha(colourOf(scene, body, r), 200));
    piece.erase(piece.begin(), piece.end() - 1);
  }
}

/// Draws outlines of a body up to `row`. Those of points are stronger than those of boxes, which overlap.
void drawOutlines(const FieldView& view, const ReportScene& scene, std::size_t body, std::size_t row) {
  if (scene.outlines_every < 0.0) return;
  const PageScene& page = scene.page;
  const auto every = scene.outlines_every > 0.0
                         ? static_cast<Tick>(std::lround(scene.outlines_every * page.rate))
                         : page.rows[row].tick / kOutlines;
  const unsigned char strength = page.bodies[body].box ? 40 : 150;
  Tick next = 0;
  for (std::size_t r = 0; r < row; ++r) {
    if (page.rows[r].tick < next) continue;
    next = page.rows[r].tick + std::max<Tick>(every, 1);
    drawBody(view, page.bodies[body], page.rows[r].poses[body],
             withAlpha(colourOf(scene, body, r), strength));
  }
}

/// Draws the paths. Dashed ones are drawn above the trails, which would hide them.
void drawPaths(const FieldView& view, const ReportScene& scene, bool dashed) {
  for (std::size_t i = 0; i < scene.paths.size(); ++i) {
    const ScenePath& path = scene.paths[i];
    if (path.dashed != dashed) continue;
    std::vector<Vec2> pixels;
    pixels.reserve(path.points.size());
    for (const Vec2 point : path.points) pixels.push_back(view.at(point));
    const Colour colour = pathColour(scene, i);
    if (path.dashed) {
      drawDashed(view.canvas, pixels, {9 * view.unit, 5 * view.unit}, 1.8 * view.unit, colour);
    } else {
      view.canvas.polyline(pixels, 1.8 * view.unit, colour);
    }
  }
}

void drawBodies(const FieldView& view, const ReportScene& scene, std::size_t row) {
  const PageScene& page = scene.page;
  for (std::size_t i = 0; i < page.bodies.size(); ++i) {
    drawBody(view, page.bodies[i], page.rows[row].poses[i], colourOf(scene, i, row));
    drawHeading(view, page.bodies[i], page.rows[row].poses[i]);
  }
}

/// The mean position of all bodies that move.
Vec2 middleOf(const PageScene& page, std::size_t row) {
  Vec2 sum;
  double count = 0.0;
  for (std::size_t i = 0; i < page.bodies.size(); ++i) {
    if (moves(page, i)) sum += page.rows[row].poses[i].position, count += 1.0;
  }
  return count > 0.0 ? sum / count : sum;
}

void drawLabel(const FieldView& view, const ReportScene& scene, const SceneMoment& moment) {
  if (moment.label.empty()) return;
  const double u = view.unit, radius = 10 * u;
  const Vec2 at = view.at(middleOf(scene.page, moment.row));
  view.canvas.fillCircle(at, radius, theme::kPage);
  view.canvas.text(at + Vec2{0.0, 0.45 * radius}, moment.label, 13 * u, theme::kText, TextAlign::kCentre);
}

/// Clears everything that was drawn beyond the walls.
void clearMargins(Canvas& canvas, const Plan& plan) {
  const Vec2 a = plan.field, b = plan.field + plan.field_size;
  canvas.fillRectangle({0, 0}, plan.size.x, a.y, theme::kPage);
  canvas.fillRectangle({0, b.y}, plan.size.x, plan.size.y - b.y, theme::kPage);
  canvas.fillRectangle({0, a.y}, a.x, b.y - a.y, theme::kPage);
  canvas.fillRectangle({b.x, a.y}, plan.size.x - b.x, b.y - a.y, theme::kPage);
}

}  // namespace

Result<Canvas> ScenePicture::draw(std::size_t row) const { return draw(row, false); }

Result<Canvas> ScenePicture::drawWhole() const { return draw(scene_->page.rows.size() - 1, true); }

Result<Canvas> ScenePicture::draw(std::size_t row, bool whole) const {
  auto measure = Canvas::create(1, 1, theme::kPage);
  if (!measure) return measure;
  const Plan plan = makePlan(*measure, *scene_, width_);
  auto canvas = Canvas::create(static_cast<int>(plan.size.x), static_cast<int>(plan.size.y), theme::kPage);
  if (!canvas) return canvas;
  const PageScene& page = scene_->page;
  const FieldView view{*canvas, plan.field + plan.field_size / 2, plan.scale, plan.unit};
  drawField(view, page.field);
  drawPaths(view, *scene_, false);
  for (std::size_t i = 0; i < page.bodies.size(); ++i) {
    if (!moves(page, i)) continue;
    if (whole) drawOutlines(view, *scene_, i, row);
    if (i >= scene_->first_trail) drawTrail(view, *scene_, i, row);
  }
  drawPaths(view, *scene_, true);
  if (whole) {
    for (const SceneMoment& moment : scene_->moments) {
      drawDrawings(view, page, page.rows[moment.row].tick);
      drawBodies(view, *scene_, moment.row);
    }
    for (const SceneMoment& moment : scene_->moments) drawLabel(view, *scene_, moment);
  }
  if (!whole || scene_->moments.empty()) drawDrawings(view, page, page.rows[row].tick);
  drawBodies(view, *scene_, row);
  clearMargins(*canvas, plan);
  drawScale(*canvas, plan);
  drawTexts(*canvas, plan, *scene_, static_cast<double>(page.rows[row].tick) / page.rate);
  return canvas;
}

}  // namespace fulbito
