#include "replays/render/field/bar_chart.hpp"

#include <cmath>

#include "replays/render/colours/palette.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

constexpr Colour kPaper{252, 252, 250}, kInk{30, 35, 42}, kReference{178, 34, 52};

Canvas drawn(const BarChart& chart) {
  auto canvas = drawBarChart(chart);
  REQUIRE(canvas);
  return std::move(*canvas);
}

BarChart twoBars() {
  BarChart chart{"Title", "axis", {{"group", {}}}, 0.0, false, ""};
  chart.groups[0].bars = {{"one", 1.0, 0, 0, "", 0}, {"two", 2.0, 0, 0, "", 1}};
  return chart;
}

struct Box {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
  int width() const { return right - left + 1; }
};

/// The bounding box of the pixels with exactly this colour.
Box bounds(const Canvas& canvas, Colour colour) {
  Box box;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      if (!same(canvas.pixel(x, y), colour)) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  }
  return box;
}

}  // namespace

TEST_CASE("bars are as long as their values and stand in order", "[unit]") {
  const Canvas canvas = drawn(twoBars());
  const Box one = bounds(canvas, seriesColour(0)), two = bounds(canvas, seriesColour(1));
  CHECK(two.width() == Approx(2.0 * one.width()).margin(4));
  CHECK(one.left == two.left);
  CHECK(one.bottom < two.top);
}

TEST_CASE("a negative bar goes left from zero", "[unit]") {
  BarChart chart = twoBars();
  chart.groups[0].bars[1].value = -1.0;
  const Canvas canvas = drawn(chart);
  const Box one = bounds(canvas, seriesColour(0)), two = bounds(canvas, seriesColour(1));
  CHECK(two.right < one.left);
  CHECK(two.width() == Approx(one.width()).margin(3));
}

TEST_CASE("an interval is a whisker over the bar's end", "[unit]") {
  BarChart chart = twoBars();
  chart.groups[0].bars[0].low = 0.5;
  chart.groups[0].bars[0].high = 1.5;
  const Canvas without = drawn(twoBars()), canvas = drawn(chart);
  const Box two = bounds(canvas, seriesColour(1)), one = bounds(canvas, seriesColour(0));
  const double unit = two.width() / 2.0;
  const auto left = [&](double value) { return static_cast<int>(two.left + value * unit); };
  CHECK(count(canvas, kInk, left(0.5) + 6, one.top, left(1.0) - 6, one.bottom + 1) >= unit / 2 - 14);
  CHECK(count(canvas, kInk, left(1.0) + 6, one.top, left(1.5) - 6, one.bottom + 1) >= unit / 2 - 14);
  CHECK(count(canvas, kInk, left(0.0) + 6, one.top, left(0.5) - 6, one.bottom + 1) == 0);
  CHECK(count(without, kInk, left(0.0), one.top, left(1.0), one.bottom + 1) == 0);
}

TEST_CASE("a bar without a value has only its remark", "[unit]") {
  BarChart chart = twoBars();
  chart.groups[0].bars[0] = {"one", std::nan(""), 0.2, 0.8, "no safe run", 0};
  const Canvas canvas = drawn(chart);
  CHECK(count(canvas, seriesColour(0)) == 0);
  chart.groups[0].bars[0].remark.clear();
  CHECK(count(drawn(chart), kPaper) - count(canvas, kPaper) < 0);  // the remark makes the chart wider
  CHECK(drawn(chart).width() < canvas.width());
}

TEST_CASE("the reference line stands at its value over the bars", "[unit]") {
  BarChart chart = twoBars();
  CHECK(count(drawn(chart), kReference) == 0);
  chart.has_reference = true;
  chart.reference = 1.5;
  const Canvas canvas = drawn(chart);
  const Box two = bounds(canvas, seriesColour(1));
  const int x = static_cast<int>(two.left + 0.75 * two.width());
  CHECK(count(canvas, kReference, x - 2, two.top, x + 3, two.bottom) >= 5);
  CHECK(count(canvas, kReference) == count(canvas, kReference, x - 2, 0, x + 3, canvas.height()));
  chart.reference_label = "bound";
  CHECK(count(drawn(chart), kPaper) < count(canvas, kPaper) - 50);
}

TEST_CASE("a long name takes two lines, and a hollow bar has a bright core", "[unit]") {
  BarChart chart = twoBars();
  const Canvas plain = drawn(chart);
  chart.groups[0].bars[0].label = "tangent-field:offset=0.0784,range=5.56,hysteresis=0.239";
  CHECK(drawn(chart).height() > plain.height() + 10);
  chart = twoBars();
  chart.groups[0].bars[1].hollow = true;
  CHECK(count(drawn(chart), seriesColour(1)) < 3 * count(plain, seriesColour(1)) / 4);
}

TEST_CASE("many groups make a tall picture, too many a refusal", "[unit]") {
  BarChart chart = twoBars();
  const int height = drawn(chart).height();
  chart.groups.resize(40, chart.groups[0]);
  const Canvas tall = drawn(chart);
  CHECK(tall.height() > 30 * height / 4);
  CHECK(bounds(tall, seriesColour(1)).bottom > tall.height() - 120);
  chart.groups.resize(1000, chart.groups[0]);
  const auto refused = drawBarChart(chart);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::kUsage);
  CHECK_THAT(refused.error().message, Catch::Contains("16384"));
}

TEST_CASE("long texts are cut and the margins stay empty", "[unit]") {
  BarChart chart = twoBars();
  chart.title = chart.axis = chart.groups[0].heading = std::string(1000, 'W');
  chart.has_reference = true;
  chart.reference_label = std::string(1000, 'W');
  for (Bar& bar : chart.groups[0].bars) bar.label = bar.remark = std::string(1000, 'W');
  const Canvas canvas = drawn(chart);
  CHECK(canvas.width() < 1500);
  CHECK(count(canvas, kPaper, 0, 0, 34, canvas.height()) == 34 * canvas.height());
  CHECK(count(canvas, kPaper, canvas.width() - 34, 0, canvas.width(), canvas.height()) ==
        34 * canvas.height());
}

TEST_CASE("empty charts and odd values can be drawn", "[unit]") {
  CHECK(drawBarChart({}));
  BarChart chart = twoBars();
  const double inf = std::numeric_limits<double>::infinity();
  chart.groups.push_back({"", {}});
  for (double value : {inf, -inf, 1e300, -1e300, 1e-300, 0.0}) {
    chart.groups[1].bars.push_back({"odd", value, -inf, value, "", 3});
    CHECK(drawBarChart(chart));
  }
}

TEST_CASE("the same chart gives the same pixels", "[unit]") {
  CHECK(equal(drawn(twoBars()), drawn(twoBars())));
}

}  // namespace fulbito
