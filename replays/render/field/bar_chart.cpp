#include "replays/render/field/bar_chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/picture.hpp"
#include "replays/render/canvas/axis.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/canvas/text_wrap.hpp"
#include "replays/render/colours/chart_style.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

using namespace chart_style;

constexpr Colour kReferenceInk{178, 34, 52};

// Sizes of the chart's parts [px].
constexpr double kMargin = 36, kPlotWidth = 640, kGap = 12, kIndent = 10;
constexpr double kMostLabel = 300, kMostRemark = 300, kLabelLine = 17;
constexpr std::size_t kMostLines = 4;  // largest number of lines of a label
constexpr double kTop = 114, kBottom = 72, kHeading = 38, kRow = 25, kBarHeight = 16, kGroupGap = 14;
constexpr double kTitleText = 24, kHeadingText = 15, kText = 14, kSmallText = 13;

/// Layout of the chart: the text columns, and the scale between them.
struct Plan {
  Axis axis;
  double left;  ///< x of the axis' low end [px]
  double width;
  double height;

  double at(double value) const {
    return left + (std::clamp(value, axis.low, axis.high) - axis.low) / (axis.high - axis.low) * kPlotWidth;
  }
};

bool hasInterval(const Bar& bar) {
  return std::isfinite(bar.low) && std::isfinite(bar.high) && bar.low < bar.high;
}

/// The value of a bar, or an empty text for a bar without a value.
std::string valueText(const Axis& axis, const Bar& bar) {
  return std::isfinite(bar.value) ? axis.text(bar.value, 1) : std::string();
}

Axis axisOf(const BarChart& chart) {
  double low = 0.0, high = 0.0;
  const auto include = [&](double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  };
  for (const BarGroup& group : chart.groups) {
    for (const Bar& bar : group.bars) {
      if (!std::isfinite(bar.value)) continue;
      include(bar.value);
      if (hasInterval(bar)) include(bar.low), include(bar.high);
    }
  }
  if (chart.has_reference) include(chart.reference);
  return niceAxis(low, high);
}

/// The width of the widest text that `text_of` returns for the bars [px].
template <typename TextOf>
double columnWidth(const Canvas& canvas, const BarChart& chart, TextOf text_of) {
  double widest = 0.0;
  for (const BarGroup& group : chart.groups) {
    for (const Bar& bar : group.bars) widest = std::max(widest, canvas.textWidth(text_of(bar), kText));
  }
  return widest;
}

std::vector<std::string> labelLines(const Canvas& canvas, const Bar& bar) {
  std::vector<std::string> lines = wrapped(canvas, bar.label, kText, kMostLabel);
  if (lines.size() <= kMostLines) return lines;
  lines.resize(kMostLines);
  lines.back() = fitted(canvas, lines.back() + "\u2026", kText, kMostLabel);
  return lines;
}

double rowHeight(const Canvas& canvas, const Bar& bar) {
  return kRow + kLabelLine * static_cast<double>(labelLines(canvas, bar).size() - 1);
}

double labelWidth(const Canvas& canvas, const BarChart& chart) {
  double widest = 0.0;
  for (const BarGroup& group : chart.groups) {
    for (const Bar& bar : group.bars) {
      for (const std::string& line : labelLines(canvas, bar)) {
        widest = std::max(widest, canvas.textWidth(line, kText));
      }
    }
  }
  return widest;
}

Plan makePlan(const Canvas& canvas, const BarChart& chart) {
  Plan plan;
  plan.axis = axisOf(chart);
  const double label = labelWidth(canvas, chart);
  const double value = columnWidth(canvas, chart, [&](const Bar& bar) { return valueText(plan.axis, bar); });
  const double remark = columnWidth(
      canvas, chart, [&](const Bar& bar) { return fitted(canvas, bar.remark, kText, kMostRemark); });
  plan.left = kMargin + kIndent + label + kGap;
  plan.width = plan.left + kPlotWidth + 2 * kGap + value + remark + kMargin;
  plan.height = kTop + kBottom;
  for (const BarGroup& group : chart.groups) {
    plan.height += kHeading + kGroupGap;
    for (const Bar& bar : group.bars) plan.height += rowHeight(canvas, bar);
  }
  return plan;
}

void drawGrid(Canvas& canvas, const Plan& plan) {
  const double bottom = plan.height - kBottom;
  for (int i = 0; i <= plan.axis.steps(); ++i) {
    const double value = plan.axis.low + i * plan.axis.step, x = std::floor(plan.at(value));
    canvas.fillRectangle({x, kTop}, 1, bottom - kTop, kGrid);
    for (double y : {kTop - 8, bottom + 19}) {
      canvas.text({x, y}, plan.axis.text(value), kSmallText, kDimInk, TextAlign::kCentre);
    }
  }
  canvas.fillRectangle({std::floor(plan.at(0.0)), kTop}, 1, bottom - kTop, kBaseLine);
}

void drawTitles(Canvas& canvas, const Plan& plan, const BarChart& chart) {
  const double width = plan.width - 2 * kMargin;
  canvas.text({kMargin, 46}, fitted(canvas, chart.title, kTitleText, width), kTitleText, kInk);
  canvas.text({plan.left + kPlotWidth / 2, plan.height - kBottom + 46},
              fitted(canvas, chart.axis, kText, kPlotWidth), kText, kInk, TextAlign::kCentre);
}

void drawReference(Canvas& canvas, const Plan& plan, const BarChart& chart) {
  if (!chart.has_reference || !std::isfinite(chart.reference)) return;
  const double x = std::round(plan.at(chart.reference)), bottom = plan.height - kBottom;
  for (int dash = 0; kTop + 8 * dash < bottom; ++dash) {
    const double y = kTop + 8 * dash;
    canvas.fillRectangle({x - 1, y}, 2, std::min(5.0, bottom - y), kReferenceInk);
  }
  const std::string label = fitted(canvas, chart.reference_label, kSmallText, kPlotWidth);
  const double half = canvas.textWidth(label, kSmallText) / 2;
  const double middle = std::clamp(x, kMargin + half, std::max(kMargin + half, plan.width - kMargin - half));
  canvas.text({middle, kTop - 26}, label, kSmallText, kReferenceInk, TextAlign::kCentre);
}

void drawWhisker(Canvas& canvas, const Plan& plan, const Bar& bar, double middle) {
  const double low = plan.at(bar.low), high = plan.at(bar.high);
  canvas.fillRectangle({low, middle - 0.75}, high - low, 1.5, kInk);
  for (double x : {low, high}) canvas.fillRectangle({x - 0.75, middle - 4.5}, 1.5, 9, kInk);
}

/// Draws text on a background of the paper's colour, so that grid and reference line do not cross it.
void drawOnPaper(Canvas& canvas, Vec2 baseline, const std::string& text, Colour colour) {
  canvas.fillRectangle(baseline - Vec2{3, 12}, canvas.textWidth(text, kText) + 6, 16, kPaper);
  canvas.text(baseline, text, kText, colour);
}

void drawBar(Canvas& canvas, const Plan& plan, const Bar& bar, double middle) {
  if (!std::isfinite(bar.value)) return;
  const double zero = plan.at(0.0), end = plan.at(bar.value), width = std::abs(end - zero);
  const Vec2 corner{std::min(zero, end), middle - kBarHeight / 2};
  const Colour colour = seriesColour(bar.colour);
  canvas.fillRectangle(corner, width, kBarHeight, darkened(colour, 0.25));
  canvas.fillRectangle(corner + Vec2{1, 1}, width - 2, kBarHeight - 2, colour);
  if (bar.hollow && width > 8) canvas.fillRectangle(corner + Vec2{4, 5}, width - 8, kBarHeight - 10, kPaper);
}

void drawBarTexts(Canvas& canvas, const Plan& plan, const Bar& bar, double middle) {
  const double baseline = middle + 5, zero = plan.at(0.0);
  const std::vector<std::string> label = labelLines(canvas, bar);
  double y = baseline - kLabelLine / 2 * static_cast<double>(label.size() - 1);
  for (const std::string& line : label) {
    canvas.text({plan.left - kGap, y}, line, kText, kInk, TextAlign::kRight);
    y += kLabelLine;
  }
  double pen = zero + 8;
  if (std::isfinite(bar.value)) {
    if (hasInterval(bar)) drawWhisker(canvas, plan, bar, middle);
    pen = std::max({zero, plan.at(bar.value), hasInterval(bar) ? plan.at(bar.high) : zero}) + 8;
    const std::string value = valueText(plan.axis, bar);
    drawOnPaper(canvas, {pen, baseline}, value, kInk);
    pen += canvas.textWidth(value, kText) + kGap;
  }
  const std::string remark = fitted(canvas, bar.remark, kText, kMostRemark);
  if (!remark.empty()) drawOnPaper(canvas, {pen, baseline}, remark, kDimInk);
}

void drawHeading(Canvas& canvas, const Plan& plan, const BarGroup& group, double top) {
  const double end = plan.width - kMargin;
  canvas.fillRectangle({kMargin, top + 6}, end - kMargin, kHeading - 8, kStripe);
  canvas.text({kMargin + kIndent, top + 26},
              fitted(canvas, group.heading, kHeadingText, end - kMargin - 2 * kIndent), kHeadingText, kInk);
}

/// Calls `heading(group, top)` for each group and `draw(bar, middle)` for each of its bars; both y in [px].
template <typename Heading, typename Draw>
void forEachRow(const Canvas& canvas, const BarChart& chart, Heading heading, Draw draw) {
  double top = kTop;
  for (const BarGroup& group : chart.groups) {
    heading(group, top);
    top += kHeading;
    for (const Bar& bar : group.bars) {
      const double height = rowHeight(canvas, bar);
      draw(bar, top + 2 + height / 2);
      top += height;
    }
    top += kGroupGap;
  }
}

}  // namespace

Result<Canvas> drawBarChart(const BarChart& chart) {
  auto measure = Canvas::create(1, 1, kPaper);
  if (!measure) return measure;
  const Plan plan = makePlan(*measure, chart);
  auto canvas =
      Canvas::create(static_cast<int>(plan.width), static_cast<int>(std::min(plan.height, 1e6)), kPaper);
  if (!canvas) return canvas;
  drawGrid(*canvas, plan);
  drawTitles(*canvas, plan, chart);
  forEachRow(
      *canvas, chart, [](const BarGroup&, double) {},
      [&](const Bar& bar, double middle) { drawBar(*canvas, plan, bar, middle); });
  drawReference(*canvas, plan, chart);
  forEachRow(
      *canvas, chart, [&](const BarGroup& group, double top) { drawHeading(*canvas, plan, group, top); },
      [&](const Bar& bar, double middle) { drawBarTexts(*canvas, plan, bar, middle); });
  return canvas;
}

}  // namespace fulbito
