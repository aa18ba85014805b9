#include "fulbito/detail/line_chart.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "fulbito/detail/canvas.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

int pixelsOf(const Canvas& canvas, Colour colour) {
  int count = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      const Colour pixel = canvas.pixel(x, y);
      count += pixel.r == colour.r && pixel.g == colour.g && pixel.b == colour.b;
    }
  }
  return count;
}

LineChart twoLines() {
  LineChart chart;
  chart.title = "Speeds";
  chart.x_axis = "time [s]", chart.y_axis = "speed [m/s]";
  chart.lines = {{"lead", {{0, 0}, {1, 2}, {2, -1}}}, {"follower", {{0, 1}, {2, 1}}}};
  return chart;
}

TEST_CASE("line chart: each line has its colour, on the paper and in the legend") {
  const auto canvas = drawLineChart(twoLines());
  REQUIRE(canvas);
  CHECK(pixelsOf(*canvas, seriesColour(0)) > 500);
  CHECK(pixelsOf(*canvas, seriesColour(1)) > 500);
}

TEST_CASE("line chart: a missing value breaks the line, and dots alone join nothing") {
  LineChart whole = twoLines(), broken = twoLines(), dots = twoLines();
  broken.lines[1].points = {{0, 1}, {kNoValue, kNoValue}, {2, 1}};
  dots.lines[1].dots = true, dots.lines[1].joined = false;
  const int all = pixelsOf(*drawLineChart(whole), seriesColour(1));
  const int rest = pixelsOf(*drawLineChart(broken), seriesColour(1));
  CHECK(rest > 0);  // the sample in the legend
  CHECK(rest < all / 4);
  const int two_dots = pixelsOf(*drawLineChart(dots), seriesColour(1));
  CHECK(two_dots > rest / 4);
  CHECK(two_dots < all / 4);
}

TEST_CASE("line chart: with equal scales a square is a square") {
  LineChart chart = twoLines();
  chart.equal_scales = true;
  chart.lines = {{"", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}};
  const auto canvas = drawLineChart(chart);
  REQUIRE(canvas);
  int left = canvas->width(), right = 0, top = canvas->height(), foot = 0;
  for (int y = 0; y < canvas->height(); ++y) {
    for (int x = 0; x < canvas->width(); ++x) {
      const Colour p = canvas->pixel(x, y), c = seriesColour(0);
      if (p.r != c.r || p.g != c.g || p.b != c.b) continue;
      left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), foot = std::max(foot, y);
    }
  }
  CHECK(std::abs((right - left) - (foot - top)) <= 2);
  CHECK(right - left > 300);
}

TEST_CASE("line chart: without a finite point it is refused by name") {
  LineChart chart = twoLines();
  chart.lines = {{"nothing", {{kNoValue, 1.0}}}};
  const auto canvas = drawLineChart(chart);
  REQUIRE(!canvas);
  CHECK(canvas.error().code == ErrorCode::kUsage);
  CHECK(canvas.error().message.find("Speeds") != std::string::npos);
}

}  // namespace
}  // namespace fulbito
