#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// One line or set of points of a chart.
struct ChartLine {
  std::string label;         ///< legend; empty: not in the legend
  std::vector<Vec2> points;  ///< x and y in the units of the axes; NaN breaks the line
  bool dots = false;         ///< a dot at each point
  bool joined = true;        ///< a line through the points
  bool dashed = false;       ///< dashed, e.g. for the figures of a paper
  std::optional<std::size_t> colour = std::nullopt;  ///< index of seriesColour; default: its index in `lines`
};

/// A vertical line with a short text at its top, e.g. where roles change.
struct ChartMark {
  double x = 0.0;     ///< in the unit of the x axis
  std::string label;  ///< may be empty
};

/// Lines over two axes, with a grid, units and a legend.
struct LineChart {
  std::string title;             ///< one line
  std::string caption;           ///< below the title, as many lines as needed; may be empty
  std::string x_axis, y_axis;    ///< with units, e.g. "speed [m/s]"
  std::vector<ChartLine> lines;  ///< in the order of the legend
  std::vector<ChartMark> marks;  ///< may be empty
  bool equal_scales = false;     ///< one unit has the same length on both axes, for paths
  bool from_zero = true;         ///< both axes include 0; never with `equal_scales`
};

/// Draws it. Errors: kIo as Canvas; kUsage without a finite point.
Result<Canvas> drawLineChart(const LineChart& chart);

}  // namespace fulbito
