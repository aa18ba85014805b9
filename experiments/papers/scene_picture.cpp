#include "experiments/papers/scene_picture.hpp"

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

// In typographic units.
constexpr double kMargin = 22, kTitle = 22, kText = 15, kLine = 21, kSample = 30, kTrail = 2.5;
constexpr int kOutlines = 24;  // of each body on its way, in the picture of a whole scene

/// A row of the legend.
struct LegendEntry {
  std::string text;
  Colour colour;
  bool dashed;
};

/// Where everything stands [px].
struct Plan {
  double unit;
  Vec2 size;
  Vec2 field;  ///< upper left corner
  Vec2 field_size;
  double scale;  ///< [px/m]
  std::vector<std::string> caption;
  std::vector<LegendEntry> legend;
};

std::vector<LegendEntry> legendOf(const ReportScene& scene) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    if (!scene.labels[i].empty()) legend.push_back({scene.labels[i], seriesColour(i), false});
  }
  for (std::size_t i = 0; i < scene.paths.size(); ++i) {
    if (scene.paths[i].label.empty()) continue;
    legend.push_back({scene.paths[i].label, seriesColour(scene.labels.size() + i), scene.paths[i].dashed});
  }
  return legend;
}

Plan makePlan(const Canvas& measure, const ReportScene& scene, double width) {
  Plan plan;
  const FieldGeometry& field = scene.page.field;
  const double goals = field.hasGoals() ? 2 * field.goal_depth : 0.0;
  const Vec2 metres{field.length + goals + 2 * kDrawnWall, field.width + 2 * kDrawnWall};
  // Tall rooms are as large as wide ones.
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
  const std::string clock = fmt::format("{:.1f} s", seconds);
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

/// The part of a drawing that lies on the canvas above the field.
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
  // As in the viewer: the newest ones, for as long as they are shown.
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

Colour colourOf(const ReportScene& scene, std::size_t body) {
  return scene.page.bodies[body].kind == BodyKind::kObstacle && body >= scene.labels.size()
             ? theme::kTennisBall
             : seriesColour(body);
}

/// Bodies that never move have neither trail nor outlines.
bool moves(const PageScene& page, std::size_t body) {
  const Vec2 first = page.rows.front().poses[body].position;
  return std::any_of(page.rows.begin(), page.rows.end(),
                     [&](const PageRow& row) { return distance(row.poses[body].position, first) > 1e-3; });
}

void drawTrail(const FieldView& view, const ReportScene& scene, std::size_t body, std::size_t row,
               bool whole) {
  const PageScene& page = scene.page;
  const Colour colour = colourOf(scene, body);
  std::vector<Vec2> trail;
  trail.reserve(row + 1);
  for (std::size_t r = 0; r <= row; ++r) trail.push_back(view.at(page.rows[r].poses[body].position));
  if (whole) {
    const std::size_t every = std::max<std::size_t>(1, row / kOutlines);
    for (std::size_t r = 0; r < row; r += every) {
      drawBody(view, page.bodies[body], page.rows[r].poses[body], withAlpha(colour, 40));
    }
  }
  view.canvas.polyline(trail, kTrail * view.unit, withAlpha(colour, 200));
}

void drawPaths(const FieldView& view, const ReportScene& scene) {
  for (std::size_t i = 0; i < scene.paths.size(); ++i) {
    const ScenePath& path = scene.paths[i];
    std::vector<Vec2> pixels;
    pixels.reserve(path.points.size());
    for (const Vec2 point : path.points) pixels.push_back(view.at(point));
    const Colour colour = seriesColour(scene.labels.size() + i);
    if (path.dashed) {
      drawDashed(view.canvas, pixels, {9 * view.unit, 5 * view.unit}, 1.8 * view.unit, colour);
    } else {
      view.canvas.polyline(pixels, 1.8 * view.unit, colour);
    }
  }
}

/// Hides what was drawn beyond the walls.
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
  drawPaths(view, *scene_);
  for (std::size_t i = 0; i < page.bodies.size(); ++i) {
    if (moves(page, i)) drawTrail(view, *scene_, i, row, whole);
  }
  drawDrawings(view, page, page.rows[row].tick);
  for (std::size_t i = 0; i < page.bodies.size(); ++i) {
    drawBody(view, page.bodies[i], page.rows[row].poses[i], colourOf(*scene_, i));
    drawHeading(view, page.bodies[i], page.rows[row].poses[i]);
  }
  clearMargins(*canvas, plan);
  drawTexts(*canvas, plan, *scene_, static_cast<double>(page.rows[row].tick) / page.rate);
  return canvas;
}

}  // namespace fulbito
