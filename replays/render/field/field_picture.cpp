#include <algorithm>

#include <fmt/format.h>

#include "fulbito/picture.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/canvas/text_wrap.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/field/legend.hpp"
#include "replays/render/field/path_drawing.hpp"

namespace fulbito {
namespace {

// Sizes in typographic units.
constexpr double kMargin = 26, kHeader = 84, kFooter = 54, kCaptionLine = 21, kCaptionText = 15;

/// Layout of the picture [px].
struct Plan {
  double unit;
  Vec2 field_corner;
  Vec2 field_size;  // including walls and goals
  Vec2 legend_corner;
  double legend_height;
  Vec2 size;
  Vec2 middle;  ///< centre of the shown part of the field [m]
  std::vector<std::string> caption;
};

/// The part of the field that is shown: the picture's window, or else all of it with walls and goals.
FieldWindow shownPart(const FieldPicture& picture) {
  if (picture.window) return *picture.window;
  const FieldGeometry& field = picture.field;
  const double goals = field.hasGoals() ? field.goal_depth : 0.0;
  const Vec2 half{field.length / 2 + goals + kDrawnWall, field.width / 2 + kDrawnWall};
  return {-half, half};
}

Plan makePlan(const Canvas& measure, const FieldPicture& picture) {
  const FieldWindow shown = shownPart(picture);
  Plan plan;
  plan.middle = (shown.low + shown.high) / 2;
  plan.field_size = (shown.high - shown.low) * static_cast<double>(picture.pixels_per_metre);
  // Letters grow with the picture, but stay readable in a small one.
  plan.unit = std::clamp(plan.field_size.y / 810.0, 0.8, 4.0);
  const double u = plan.unit;
  const Legend legend(measure, picture, u);
  if (!picture.caption.empty()) {
    const double width = plan.field_size.x + kMargin * u + legend.width();
    plan.caption = wrapped(measure, picture.caption, kCaptionText * u, std::min(width, 1e5));
  }
  const double caption = kCaptionLine * u * static_cast<double>(plan.caption.size());
  plan.field_corner = {kMargin * u, kHeader * u + caption};
  plan.legend_corner = {plan.field_corner.x + plan.field_size.x + kMargin * u, plan.field_corner.y};
  plan.legend_height = std::max(legend.height(), plan.field_size.y);
  plan.size = {
      plan.legend_corner.x + legend.width() + kMargin * u,
      plan.field_corner.y + std::max(plan.field_size.y + kFooter * u, plan.legend_height + kMargin * u)};
  return plan;
}

/// The paths clipped to the window, for marks on them. A path that ends outside has no end mark.
std::vector<DrawnPath> shownPaths(std::vector<DrawnPath> paths, const FieldWindow& window) {
  const auto outside = [&](Vec2 p) {
    return !(p.x > window.low.x && p.x < window.high.x && p.y > window.low.y && p.y < window.high.y);
  };
  for (DrawnPath& path : paths) {
    if (!path.points.empty() && outside(path.points.back())) path.arrived = true;
    std::erase_if(path.points, outside);
  }
  return paths;
}

/// A size as int. NaN and sizes beyond int become a size that Canvas rejects.
int wholePixels(double size) { return size < 1e6 ? static_cast<int>(size) : 1'000'000; }

/// Paints over what paths and obstacles drew outside the field.
void clearMargins(Canvas& canvas, const Plan& plan) {
  const Vec2 a = plan.field_corner, b = plan.field_corner + plan.field_size;
  const double width = canvas.width(), height = canvas.height();
  canvas.fillRectangle({0, 0}, width, a.y, theme::kPage);
  canvas.fillRectangle({0, b.y}, width, height - b.y, theme::kPage);
  canvas.fillRectangle({0, a.y}, a.x, plan.field_size.y, theme::kPage);
  canvas.fillRectangle({b.x, a.y}, width - b.x, plan.field_size.y, theme::kPage);
}

std::string subtitle(const FieldPicture& picture) {
  const FieldGeometry& field = picture.field;
  std::string whole = fmt::format("{}, {:.2f} m \u00d7 {:.2f} m", field.name, field.length, field.width);
  if (!picture.window) return whole;
  const Vec2 size = picture.window->high - picture.window->low;
  return fmt::format("detail, {:.2f} m \u00d7 {:.2f} m, of {}", size.x, size.y, whole);
}

void drawHeader(Canvas& canvas, const FieldPicture& picture, const Plan& plan) {
  const double u = plan.unit, width = canvas.width() - 2 * kMargin * u;
  canvas.text({kMargin * u, 42 * u}, fitted(canvas, picture.title, 25 * u, width), 25 * u, theme::kText);
  double y = 66 * u;
  for (const std::string& line : plan.caption) {
    canvas.text({kMargin * u, y + 2 * u}, line, kCaptionText * u, theme::kText);
    y += kCaptionLine * u;
  }
  canvas.text({kMargin * u, y}, fitted(canvas, subtitle(picture), 14 * u, width), 14 * u, theme::kDimText);
}

void drawScaleBar(const FieldView& view, const Plan& plan) {
  const double u = plan.unit;
  const Vec2 a = plan.field_corner + Vec2{4 * u, plan.field_size.y + 26 * u}, b = a + Vec2{view.px(0.1), 0};
  view.canvas.line(a, b, 2 * u, theme::kText);
  for (Vec2 end : {a, b}) view.canvas.line(end - Vec2{0, 5 * u}, end + Vec2{0, 5 * u}, 2 * u, theme::kText);
  view.canvas.text(b + Vec2{10 * u, 5 * u}, "0.1 m", 14 * u, theme::kText);
}

}  // namespace

Result<Canvas> drawFieldPicture(const FieldPicture& picture) {
  if (picture.pixels_per_metre < 1) return fail(ErrorCode::kUsage, "pixels_per_metre must be at least 1");
  if (auto valid = validate(picture.field); !valid) return tl::unexpected(valid.error());
  const FieldWindow shown = shownPart(picture);
  if (!(shown.low.x < shown.high.x && shown.low.y < shown.high.y)) {
    return fail(ErrorCode::kUsage, "the window of the picture is empty");
  }
  auto measure = Canvas::create(1, 1, theme::kPage);
  if (!measure) return measure;
  const Plan plan = makePlan(*measure, picture);
  auto canvas = Canvas::create(wholePixels(plan.size.x), wholePixels(plan.size.y), theme::kPage);
  if (!canvas && canvas.error().code == ErrorCode::kUsage) {
    return fail(ErrorCode::kUsage, canvas.error().message + "; lower pixels_per_metre");
  }
  if (!canvas) return canvas;
  const double scale = picture.pixels_per_metre;
  const Vec2 centre = plan.field_corner + plan.field_size / 2 - Vec2{plan.middle.x, -plan.middle.y} * scale;
  const FieldView view{*canvas, centre, scale, plan.unit};
  drawField(view, picture.field);
  drawArrows(view, picture.arrows);
  for (const ObstacleSpec& obstacle : picture.layout.obstacles) drawObstacle(view, obstacle);
  // In a detail the paths lie above the start, because they show what happens there.
  if (picture.window) drawStart(view, picture.robot, picture.layout.start);
  drawPaths(view, picture.robot, picture.paths);
  if (!picture.window) drawStart(view, picture.robot, picture.layout.start);
  drawGoal(view, picture.layout);
  drawPathMarks(view, picture.window ? shownPaths(picture.paths, shown) : picture.paths);
  clearMargins(*canvas, plan);
  drawHeader(*canvas, picture, plan);
  drawScaleBar(view, plan);
  Legend(*canvas, picture, plan.unit).draw(view, plan.legend_corner, plan.legend_height);
  return canvas;
}

}  // namespace fulbito
