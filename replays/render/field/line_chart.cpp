#include "fulbito/detail/line_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/picture.hpp"
#include "replays/render/canvas/axis.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/canvas/text_wrap.hpp"
#include "replays/render/colours/chart_style.hpp"
#include "replays/render/colours/palette.hpp"
#include "replays/render/field/field_drawing.hpp"

namespace fulbito {
namespace {

using namespace chart_style;

// Sizes of the chart's parts [px].
constexpr double kMargin = 36, kPlotWidth = 820, kPlotHeight = 460, kLegendSample = 34, kLegendRow = 24;
constexpr double kTop = 64, kCaptionLine = 20, kBottom = 68, kTickRoom = 74, kGap = 18;
constexpr double kMostLegend = 320, kMarkRoom = 22;
constexpr double kTitleText = 24, kText = 14, kSmallText = 13;
constexpr double kStroke = 2.5, kDot = 4.0;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
};

bool drawable(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Layout and scale of the plot.
struct Plan {
  Axis x, y;
  Vec2 corner;  ///< upper left corner of the plot [px]
  Vec2 size;    ///< size of the plot [px]
  Vec2 whole;   ///< size of the picture [px]
  std::vector<std::string> caption;

  Vec2 at(Vec2 p) const {
    return {corner.x + (p.x - x.low) / (x.high - x.low) * size.x,
            corner.y + size.y - (p.y - y.low) / (y.high - y.low) * size.y};
  }
};

/// An axis over a range. An empty range is extended, because a scale needs an extent.
Axis axisOver(Range range, bool from_zero) {
  if (from_zero) range.include(0.0);
  if (range.low == range.high) range.low -= 0.5, range.high += 0.5;
  return niceAxis(range.low, range.high);
}

std::string legendText(const Canvas& canvas, const ChartLine& line) {
  return fitted(canvas, line.label, kText, kMostLegend);
}

double legendWidth(const Canvas& canvas, const LineChart& chart) {
  double widest = 0.0;
  for (const ChartLine& line : chart.lines) {
    widest = std::max(widest, canvas.textWidth(legendText(canvas, line), kText));
  }
  return widest > 0.0 ? kGap + kLegendSample + 8 + widest : 0.0;
}

double legendHeight(const LineChart& chart) {
  return kLegendRow * static_cast<double>(std::count_if(chart.lines.begin(), chart.lines.end(),
                                                        [](const auto& l) { return !l.label.empty(); }));
}

/// The size of the plot. With equal scales it has the shape of its ranges, within the usual size.
Vec2 plotSize(const Plan& plan, bool equal_scales) {
  if (!equal_scales) return {kPlotWidth, kPlotHeight};
  const double wide = plan.x.high - plan.x.low, high = plan.y.high - plan.y.low;
  const double scale = std::min(kPlotWidth / wide, kPlotWidth / high);
  return {wide * scale, high * scale};
}

Plan makePlan(const Canvas& canvas, const LineChart& chart, Range x, Range y) {
  Plan plan;
  const bool from_zero = chart.from_zero && !chart.equal_scales;
  plan.x = axisOver(x, from_zero), plan.y = axisOver(y, from_zero);
  plan.size = plotSize(plan, chart.equal_scales);
  plan.whole.x = kMargin + kTickRoom + plan.size.x + legendWidth(canvas, chart) + kMargin;
  if (!chart.caption.empty()) {
    plan.caption = wrapped(canvas, chart.caption, kText, plan.whole.x - 2 * kMargin);
  }
  const bool marked = !chart.marks.empty();
  plan.corner = {kMargin + kTickRoom, kTop + kCaptionLine * static_cast<double>(plan.caption.size()) + kGap +
                                          (marked ? kMarkRoom : 0.0)};
  plan.whole.y = plan.corner.y + std::max(plan.size.y, legendHeight(chart)) + kBottom;
  return plan;
}

void drawTexts(Canvas& canvas, const Plan& plan, const LineChart& chart) {
  const double width = plan.whole.x - 2 * kMargin;
  canvas.text({kMargin, 46}, fitted(canvas, chart.title, kTitleText, width), kTitleText, kInk);
  double y = kTop + kCaptionLine / 2;
  for (const std::string& line : plan.caption) {
    canvas.text({kMargin, y}, line, kText, kDimInk);
    y += kCaptionLine;
  }
  const double foot = plan.corner.y + plan.size.y;
  canvas.text({plan.corner.x + plan.size.x / 2, foot + 46}, chart.x_axis, kText, kInk, TextAlign::kCentre);
  canvas.text({kMargin, plan.corner.y - (chart.marks.empty() ? 8 : 8 + kMarkRoom)}, chart.y_axis, kText,
              kInk);
}

void drawGrid(Canvas& canvas, const Plan& plan) {
  const Vec2 end = plan.corner + plan.size;
  for (int i = 0; i <= plan.x.steps(); ++i) {
    const double value = plan.x.low + i * plan.x.step, at = std::floor(plan.at({value, plan.y.low}).x);
    canvas.fillRectangle({at, plan.corner.y}, 1, plan.size.y, kGrid);
    canvas.text({at, end.y + 20}, plan.x.text(value), kSmallText, kDimInk, TextAlign::kCentre);
  }
  for (int i = 0; i <= plan.y.steps(); ++i) {
    const double value = plan.y.low + i * plan.y.step, at = std::floor(plan.at({plan.x.low, value}).y);
    canvas.fillRectangle({plan.corner.x, at}, plan.size.x, 1, value == 0.0 ? kBaseLine : kGrid);
    canvas.text({plan.corner.x - 10, at + 5}, plan.y.text(value), kSmallText, kDimInk, TextAlign::kRight);
  }
}

void drawMarks(Canvas& canvas, const Plan& plan, const LineChart& chart) {
  for (const ChartMark& mark : chart.marks) {
    const double x = plan.at({mark.x, plan.y.low}).x;
    const Vec2 top{x, plan.corner.y}, foot{x, plan.corner.y + plan.size.y};
    drawDashed(canvas, std::vector<Vec2>{top, foot}, {6, 3}, 1, kBaseLine);
    canvas.text({x, plan.corner.y - 6}, mark.label, kSmallText, kDimInk, TextAlign::kCentre);
  }
}

void drawStroke(Canvas& canvas, std::span<const Vec2> pixels, bool dashed, Colour colour) {
  if (pixels.size() < 2) return;
  if (dashed) {
    drawDashed(canvas, pixels, {12, 7}, kStroke, colour);
  } else {
    canvas.polyline(pixels, kStroke, colour);
  }
}

void drawLine(Canvas& canvas, const Plan& plan, const ChartLine& line, Colour colour) {
  std::vector<Vec2> piece;
  for (const Vec2 point : line.points) {
    if (drawable(point)) {
      piece.push_back(plan.at(point));
      if (line.dots) canvas.fillCircle(piece.back(), kDot, colour);
    } else {
      if (line.joined) drawStroke(canvas, piece, line.dashed, colour);
      piece.clear();
    }
  }
  if (line.joined) drawStroke(canvas, piece, line.dashed, colour);
}

Colour colourOf(const LineChart& chart, std::size_t index) {
  return seriesColour(chart.lines[index].colour.value_or(index));
}

void drawLegend(Canvas& canvas, const Plan& plan, const LineChart& chart) {
  Vec2 pen{plan.corner.x + plan.size.x + kGap, plan.corner.y + 8};
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    const ChartLine& line = chart.lines[i];
    if (line.label.empty()) continue;
    const Colour colour = colourOf(chart, i);
    const Vec2 sample = pen + Vec2{kLegendSample, 0};
    if (line.joined) drawStroke(canvas, std::vector<Vec2>{pen, sample}, line.dashed, colour);
    if (line.dots) canvas.fillCircle((pen + sample) / 2, kDot, colour);
    canvas.text(sample + Vec2{8, 5}, legendText(canvas, line), kText, kInk);
    pen.y += kLegendRow;
  }
}

}  // namespace

Result<Canvas> drawLineChart(const LineChart& chart) {
  Range x, y;
  for (const ChartLine& line : chart.lines) {
    for (const Vec2 point : line.points) {
      if (drawable(point)) x.include(point.x), y.include(point.y);
    }
  }
  if (!(x.low <= x.high)) return fail(ErrorCode::kUsage, "chart '" + chart.title + "' has no finite point");
  auto measure = Canvas::create(1, 1, kPaper);
  if (!measure) return measure;
  const Plan plan = makePlan(*measure, chart, x, y);
  auto canvas = Canvas::create(static_cast<int>(plan.whole.x), static_cast<int>(plan.whole.y), kPaper);
  if (!canvas) return canvas;
  drawGrid(*canvas, plan);
  drawMarks(*canvas, plan, chart);
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    drawLine(*canvas, plan, chart.lines[i], colourOf(chart, i));
  }
  drawTexts(*canvas, plan, chart);
  drawLegend(*canvas, plan, chart);
  return canvas;
}

}  // namespace fulbito
