#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// One bar: its value with an optional interval and a remark drawn at its end.
struct Bar {
  std::string label;
  double value = 0.0;  ///< NaN: no bar, only the remark (e.g. "no safe run")
  double low = 0.0;    ///< low end of the interval; equal to `high`: no interval
  double high = 0.0;
  std::string remark;
  std::size_t colour = 0;  ///< index for `seriesColour`
  bool hollow = false;     ///< drawn with a bright core, to tell two bars of the same colour apart
};

/// A group of bars under a heading, e.g. one speed.
struct BarGroup {
  std::string heading;
  std::vector<Bar> bars;
};

/// Horizontal bar chart with an axis, a grid, units and an optional reference line.
struct BarChart {
  std::string title;
  std::string axis;  ///< e.g. "time / T*"
  std::vector<BarGroup> groups;
  double reference = 0.0;  ///< value marked by a line
  bool has_reference = false;
  std::string reference_label;
};

/// Draws the chart, as tall as it needs to be. Long labels take two lines or more. Remarks that are too long,
/// and labels beyond four lines, end in an ellipsis. Errors: kIo as `Canvas`; kUsage for more bars than fit
/// in the tallest picture (about 640).
Result<Canvas> drawBarChart(const BarChart& chart);

}  // namespace fulbito
