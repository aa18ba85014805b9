#include "replays/render/field/legend.hpp"

#include <algorithm>
#include <functional>

#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/canvas/text_wrap.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/field/path_drawing.hpp"

namespace fulbito {
namespace {

// Sizes in typographic units.
constexpr double kWidth = 400, kPadding = 20, kHeading = 34, kPathRow = 29, kKeyRow = 30, kGap = 18;
constexpr double kSwatch = 72, kText = 15, kRemark = 13, kTextLine = 19;
constexpr std::size_t kMostLines = 6;  // largest number of lines of a label

struct KeyRow {
  std::string label;
  std::function<void(const FieldView&, Vec2)> draw;  // draws the symbol around a point
};

/// A view for a symbol of the key, with world coordinates in metres around `centre`.
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
      return "moving obstacle and its path";
    case ObstacleMotion::kPushable:
      return "pushable obstacle";
    case ObstacleMotion::kFixed:
      break;
  }
  return "obstacle";
}

/// Adds a row for the first obstacle with this kind of motion, if there is one.
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
  return {"failed run", [](const FieldView& view, Vec2 centre) {
            const double u = view.unit;
            const std::array<Vec2, 2> line{centre - Vec2{26 * u, 0}, centre + Vec2{26 * u, 0}};
            drawDashed(view.canvas, line, failedDashes(view), pathThickness(view), theme::kDimText);
          }};
}

KeyRow endRow() {
  return {"end of a run that did not arrive", [](const FieldView& view, Vec2 centre) {
            drawCross(view, centre, 7 * view.unit, theme::kDimText);
          }};
}

KeyRow touchRow() {
  return {"touch", [](const FieldView& view, Vec2 centre) { drawTouch(view, centre, theme::kDimText); }};
}

KeyRow hollowRow() {
  return {"same method, other settings", [](const FieldView& view, Vec2 centre) {
            const double u = view.unit;
            const std::array<Vec2, 2> line{centre - Vec2{26 * u, 0}, centre + Vec2{26 * u, 0}};
            view.canvas.polyline(line, pathThickness(view), theme::kDimText);
            drawCore(view, line);
          }};
}

KeyRow arrowRow(const std::string& label) {
  return {label, [](const FieldView& view, Vec2 centre) {
            drawArrows(symbolView(view, centre), {"", 0.09, {Pose2{}}});
          }};
}

std::vector<KeyRow> keyRows(const FieldPicture& picture) {
  std::vector<KeyRow> rows{startRow(), goalRow(picture.layout)};
  for (ObstacleMotion motion : {ObstacleMotion::kFixed, ObstacleMotion::kPath, ObstacleMotion::kPushable}) {
    addObstacleRow(rows, picture.layout, motion);
  }
  const auto any = [&](auto test) { return std::any_of(picture.paths.begin(), picture.paths.end(), test); };
  if (!picture.arrows.places.empty()) rows.push_back(arrowRow(picture.arrows.label));
  if (any([](const DrawnPath& path) { return path.hollow; })) rows.push_back(hollowRow());
  if (any([](const DrawnPath& path) { return path.failed; })) rows.push_back(failedRow());
  if (any([](const DrawnPath& path) { return path.failed && !path.arrived; })) rows.push_back(endRow());
  if (any([](const DrawnPath& path) { return !path.touches.empty(); })) rows.push_back(touchRow());
  return rows;
}

}  // namespace

Legend::Legend(const Canvas& measure, const FieldPicture& picture, double unit)
    : picture_(picture), unit_(unit) {
  rows_.reserve(picture.paths.size());
  for (const DrawnPath& path : picture.paths) rows_.push_back(pathRow(measure, path));
}

double Legend::width() const { return kWidth * unit_; }

double Legend::height() const {
  const double keys = static_cast<double>(keyRows(picture_).size());
  double paths = 0.0;
  for (const PathRow& row : rows_) paths += row.height;
  const double upper = rows_.empty() ? 0.0 : (kHeading + kGap) * unit_ + paths;
  return (2 * kPadding + kHeading + keys * kKeyRow) * unit_ + upper;
}

Legend::PathRow Legend::pathRow(const Canvas& measure, const DrawnPath& path) const {
  const double u = unit_, inner = (kWidth - 2 * kPadding - kSwatch) * u;
  PathRow row;
  row.label = wrapped(measure, path.label, kText * u, inner);
  if (row.label.size() > kMostLines) {
    row.label.resize(kMostLines);
    row.label.back() = fitted(measure, row.label.back() + "\u2026", kText * u, inner);
  }
  row.remark = fitted(measure, path.remark, kRemark * u, inner);
  const double beside = measure.textWidth(row.label.back(), kText * u) + 12 * u;
  row.remark_below = beside + measure.textWidth(row.remark, kRemark * u) > inner;
  const double lines = static_cast<double>(row.label.size()) + (row.remark_below ? 1.0 : 0.0);
  row.height = (kPathRow + (lines - 1.0) * kTextLine) * u;
  return row;
}

void Legend::drawPathRow(const FieldView& view, Vec2 corner, std::size_t index) const {
  const DrawnPath& path = picture_.paths[index];
  const PathRow& row = rows_[index];
  const Colour colour = pathColour(path, index);
  const double u = view.unit, inner = (kWidth - 2 * kPadding - kSwatch) * u;
  const Vec2 middle = corner + Vec2{0, kPathRow / 2 * u};
  const std::array<Vec2, 2> sample{middle + Vec2{26 * u, 0}, middle + Vec2{58 * u, 0}};
  if (path.failed) {
    drawDashed(view.canvas, sample, failedDashes(view), pathThickness(view), colour);
  } else {
    view.canvas.polyline(sample, pathThickness(view), colour);
  }
  if (path.hollow) drawCore(view, sample);
  drawBadge(view, middle + Vec2{10 * u, 0}, index, colour);
  double baseline = middle.y + 5 * u;
  for (const std::string& line : row.label) {
    view.canvas.text({corner.x + kSwatch * u, baseline}, line, kText * u, theme::kText);
    baseline += kTextLine * u;
  }
  if (!row.remark_below) baseline -= kTextLine * u;
  view.canvas.text({corner.x + kSwatch * u + inner, baseline}, row.remark, kRemark * u,
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
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      drawPathRow(view, pen, i);
      pen.y += rows_[i].height;
    }
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
