#include "apps/view/help_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "apps/view/key_bindings.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kText = 17.0, kBadgeText = 12.0;   // [px] at 900 x 780
constexpr double kSmallest = 7.0, kLargest = 30.0;  // [px]
constexpr double kLine = 1.62;                      // line height, relative to the font size
constexpr double kHintText = 12.0;                  // [px] at 900 x 780
constexpr double kEdge = 22.0;                      // [px] from the board's ends to its texts at 900 x 780
constexpr double kNoteText = 13.0;                  // [px] at 900 x 780
constexpr double kFoot = 36.0;                      // [px] height of the bar of time at 900 x 780
constexpr double kBoard = 84.0;                     // [px] height of the score board at 900 x 780
constexpr double kShare = 0.94;                     // largest part of the picture that the plate covers

struct HelpColours {
  Colour plate, edge, keys, text;
};

HelpColours coloursOf(PictureTheme theme) {
  if (theme == PictureTheme::kDark) {
    return {{18, 22, 28, 238}, {92, 102, 116, 255}, {255, 255, 255, 255}, {190, 199, 210, 255}};
  }
  return {{255, 255, 255, 242}, {150, 158, 168, 255}, {16, 20, 26, 255}, {70, 78, 90, 255}};
}

double unitOf(const Canvas& canvas) { return std::min(canvas.width() / 900.0, canvas.height() / 780.0); }

std::vector<KeyHelp> rowsOf(bool live) {
  std::vector<KeyHelp> rows;
  for (const KeyHelp& row : keyHelp()) {
    if (live ? row.live : row.replay) rows.push_back(row);
  }
  return rows;
}

/// A rectangle with rounded corners.
void drawPlate(Canvas& canvas, Vec2 corner, Vec2 size, double radius, Colour colour) {
  constexpr int kArc = 3;  // Canvas fills at most sixteen corners
  std::vector<Vec2> points;
  const std::array<Vec2, 4> centres{corner + Vec2{radius, radius}, corner + Vec2{size.x - radius, radius},
                                    corner + size - Vec2{radius, radius},
                                    corner + Vec2{radius, size.y - radius}};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (int k = 0; k <= kArc; ++k) {
      const double turns = static_cast<double>(i) + 2.0 + static_cast<double>(k) / kArc;
      points.push_back(centres[i] + math::unit(turns * math::kPi / 2) * radius);
    }
  }
  canvas.fillConvex(points, colour);
}

/// Layout of the list of keys.
struct HelpPlan {
  double size = 0.0, keys = 0.0, words = 0.0;  ///< font size, and widths of the two columns [px]

  double gap() const { return 1.4 * size; }
  double width() const { return keys + words + 3 * gap(); }
};

HelpPlan planOf(const Canvas& canvas, const std::vector<KeyHelp>& rows, double size) {
  HelpPlan plan{size, 0.0, 0.0};
  for (const KeyHelp& row : rows) {
    plan.keys =
        std::max(plan.keys, canvas.labelWidth(std::string(row.keys), {size, {}, TextAlign::kLeft, true}));
    plan.words =
        std::max(plan.words, canvas.labelWidth(std::string(row.text), {size, {}, TextAlign::kLeft, false}));
  }
  return plan;
}

}  // namespace

void drawHelp(Canvas& canvas, PictureTheme theme, bool live) {
  const std::vector<KeyHelp> rows = rowsOf(live);
  const HelpColours colours = coloursOf(theme);
  const auto count = static_cast<double>(rows.size());
  const double fits = kShare * canvas.height() / (kLine * (count + 1.4));
  double size = std::clamp(std::min(kText * unitOf(canvas), fits), kSmallest, kLargest);
  HelpPlan plan = planOf(canvas, rows, size);
  if (plan.width() > kShare * canvas.width()) {
    size = std::max(kSmallest, size * kShare * canvas.width() / plan.width());
    plan = planOf(canvas, rows, size);
  }
  const Vec2 extent{plan.width(), kLine * size * (count + 1.4)};
  const Vec2 corner{std::round((canvas.width() - extent.x) / 2),
                    std::round((canvas.height() - extent.y) / 2)};
  drawPlate(canvas, corner - Vec2{1.5, 1.5}, extent + Vec2{3.0, 3.0}, 0.7 * size + 1.5, colours.edge);
  drawPlate(canvas, corner, extent, 0.7 * size, colours.plate);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = std::round(corner.y + kLine * size * (static_cast<double>(i) + 1.35));
    canvas.label({corner.x + plan.gap(), y}, std::string(rows[i].keys),
                 {size, colours.keys, TextAlign::kLeft, true});
    canvas.label({corner.x + plan.keys + 2 * plan.gap(), y}, std::string(rows[i].text),
                 {size, colours.text, TextAlign::kLeft, false});
  }
}

void drawBadge(Canvas& canvas, const std::string& word) {
  const double size = std::max(kBadgeText * unitOf(canvas), 9.0);
  const TextStyle style{size, {20, 20, 20, 255}, TextAlign::kCentre, true};
  const Vec2 extent{std::round(canvas.labelWidth(word, style) + 1.4 * size), std::round(1.5 * size)};
  const Vec2 corner{std::round((canvas.width() - extent.x) / 2), std::round(kBoard * unitOf(canvas)) + 3.0};
  drawPlate(canvas, corner, extent, 0.3 * size, {255, 176, 46, 255});
  canvas.label({corner.x + extent.x / 2, std::round(corner.y + 1.1 * size)}, word, style);
}

void drawHint(Canvas& canvas, PictureTheme theme, const std::string& hint) {
  const double unit = unitOf(canvas), size = std::max(kHintText * unit, 8.0);
  canvas.label({std::round(canvas.width() - kEdge * unit), std::round(kBoard * unit - 0.45 * size)}, hint,
               {size, coloursOf(theme).text, TextAlign::kRight, false});
}

void drawNote(Canvas& canvas, PictureTheme theme, const std::string& note) {
  if (note.empty()) return;
  const HelpColours colours = coloursOf(theme);
  const double size = std::max(kNoteText * unitOf(canvas), 10.0);
  const TextStyle style{size, colours.keys, TextAlign::kCentre, false};
  const Vec2 extent{std::round(canvas.labelWidth(note, style) + 2.0 * size), std::round(1.8 * size)};
  const Vec2 corner{std::round((canvas.width() - extent.x) / 2),
                    std::round(canvas.height() - kFoot * unitOf(canvas) - extent.y)};
  drawPlate(canvas, corner - Vec2{1.0, 1.0}, extent + Vec2{2.0, 2.0}, extent.y / 2 + 1.0, colours.edge);
  drawPlate(canvas, corner, extent, extent.y / 2, colours.plate);
  canvas.label({corner.x + extent.x / 2, std::round(corner.y + 1.25 * size)}, note, style);
}

}  // namespace fulbito
