#include "replays/render/legend.hpp"

#include <algorithm>
#include <functional>

#include "replays/render/field_drawing.hpp"
#include "replays/render/palette.hpp"
#include "replays/render/path_drawing.hpp"
#include "replays/render/text_fit.hpp"

namespace fulbito {
namespace {

// All in typographic units.
constexpr double kWidth = 400, kPadding = 20, kHeading = 34, kPathRow = 29, kKeyRow = 30, kGap = 18;
constexpr double kSwatch = 72, kText = 15, kRemark = 13;

struct KeyRow {
  std::string label;
  std::function<void(const FieldView&, Vec2)> draw;  // around a point
};

/// The view in which world coordinates are metres around `centre`, for a symbol of the key.
FieldView symbolView(const FieldView& view, Vec2 centre) {
  return {view.canvas, centre, 300.0 * view.unit, view.unit};
}

KeyRow startRow() {
  return {"start", [](const FieldView& view, Vec2 centre) {
            drawStart(symbolView(view, centre), RobotModel{}, Pose2{});
          }};
}

KeyRow goalRow(const Layout& layout) {
  return {layout.goal_heading ? "goal, tolerance and wanted heading" : "goal with its tolerance",
          [heading = layout.goal_heading](const FieldView& view, Vec2 centre) {
            Layout sample;
            sample.goal_heading = heading ? std::optional(0.0) : std::nullopt;
            drawGoal(symbolView(view, heading ? centre - Vec2{10 * view.unit, 0} : centre), sample);
          }};
}

const char* obstacleLabel(ObstacleMotion motion) {
  switch (motion) {
    case ObstacleMotion::kPath:
      return "moving obstacle and its way";
    case ObstacleMotion::kPushable:
      return "obstacle that can be pushed";
    case ObstacleMotion::kFixed:
      break;
  }
  return "obstacle";
}

/// A row for the first obstacle that moves as `motion`, if there is one.
void addObstacleRow(std::vector<KeyRow>& rows, const Layout& layout, ObstacleMotion motion) {
  const auto found = std::find_if(layout.obstacles.begin(), layout.obstacles.end(),
                                  [motion](const ObstacleSpec& o) { return o.motion == motion; });
  if (found == layout.obstacles.end()) return;
  rows.push_back({obstacleLabel(motion), [shape = found->shape, motion](const FieldView& view, Vec2 centre) {
                    const bool moving = motion == ObstacleMotion::kPath;
                    ObstacleSpec sample;
                    sample.shape = shape;
                    sample.motion = motion;
                    sample.length = sample.width = 0.06;
                    sample.pose.position = {moving ? -0.06 : 0.0, 0.0};
                    if (moving) sample.path = {{-0.06, 0.0}, {0.1, 0.0}};
                    sample.path_end = PathEnd::kStop;
                    drawObstacle(symbolView(view, centre), sample);
                  }});
}

KeyRow failedRow() {
  return {"failed run and where it ended", [](const FieldView& view, Vec2 centre) {
            const double u = view.unit;
            const std::array<Vec2, 2> line{centre - Vec2{30 * u, 0}, centre + Vec2{20 * u, 0}};
            drawDashed(view.canvas, line, failedDashes(view), pathThickness(view), theme::kDimText);
            drawCross(view, line[1], 7 * u, theme::kDimText);
          }};
}

std::vector<KeyRow> keyRows(const FieldPicture& picture) {
  std::vector<KeyRow> rows{startRow(), goalRow(picture.layout)};
  for (ObstacleMotion motion : {ObstacleMotion::kFixed, ObstacleMotion::kPath, ObstacleMotion::kPushable}) {
    addObstacleRow(rows, picture.layout, motion);
  }
  const bool failed = std::any_of(picture.paths.begin(), picture.paths.end(),
                                  [](const DrawnPath& path) { return path.failed; });
  if (failed) rows.push_back(failedRow());
  return rows;
}

}  // namespace

double Legend::width() const { return kWidth * unit_; }

double Legend::height() const {
  const double paths = static_cast<double>(picture_.paths.size());
  const double keys = static_cast<double>(keyRows(picture_).size());
  const double upper = paths > 0 ? kHeading + paths * kPathRow + kGap : 0.0;
  return (2 * kPadding + upper + kHeading + keys * kKeyRow) * unit_;
}

void Legend::drawPathRow(const FieldView& view, Vec2 corner, std::size_t index) const {
  const DrawnPath& path = picture_.paths[index];
  const double u = view.unit, inner = (kWidth - 2 * kPadding - kSwatch) * u;
  const Vec2 middle = corner + Vec2{0, kPathRow / 2 * u};
  const std::array<Vec2, 2> sample{middle + Vec2{26 * u, 0}, middle + Vec2{58 * u, 0}};
  if (path.failed) {
    drawDashed(view.canvas, sample, failedDashes(view), pathThickness(view), seriesColour(index));
  } else {
    view.canvas.polyline(sample, pathThickness(view), seriesColour(index));
  }
  drawBadge(view, middle + Vec2{10 * u, 0}, index);
  const double baseline = middle.y + 5 * u;
  const std::string remark = fitted(view.canvas, path.remark, kRemark * u, 0.55 * inner);
  const double remark_width = view.canvas.textWidth(remark, kRemark * u);
  const std::string label = fitted(view.canvas, path.label, kText * u, inner - remark_width - 12 * u);
  view.canvas.text({corner.x + kSwatch * u, baseline}, label, kText * u, theme::kText);
  view.canvas.text({corner.x + kSwatch * u + inner, baseline}, remark, kRemark * u,
                   path.failed ? theme::kWarningText : theme::kDimText, TextAlign::kRight);
}

void Legend::draw(const FieldView& view, Vec2 corner, double height) const {
  const double u = view.unit;
  view.canvas.fillRectangle(corner, width(), height, theme::kPanel);
  Vec2 pen = corner + Vec2{kPadding, kPadding} * u;
  const double inner = width() - 2 * kPadding * u;
  const auto heading = [&](const std::string& text) {
    view.canvas.text(pen + Vec2{0, 13 * u}, text, 13 * u, theme::kDimText);
    view.canvas.fillRectangle(pen + Vec2{0, 22 * u}, inner, std::max(1.0, u), theme::kRule);
    pen.y += kHeading * u;
  };
  if (!picture_.paths.empty()) {
    heading("PATHS");
    for (std::size_t i = 0; i < picture_.paths.size(); ++i, pen.y += kPathRow * u) drawPathRow(view, pen, i);
    pen.y += kGap * u;
  }
  heading("KEY");
  for (const KeyRow& row : keyRows(picture_)) {
    row.draw(view, pen + Vec2{29, kKeyRow / 2} * u);
    view.canvas.text(pen + Vec2{kSwatch, kKeyRow / 2 + 5} * u, row.label, 14 * u, theme::kDimText);
    pen.y += kKeyRow * u;
  }
}

}  // namespace fulbito
