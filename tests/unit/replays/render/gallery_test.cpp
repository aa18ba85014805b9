#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

// Pictures to look at: `render_test "[gallery]"` writes them to render-gallery/ of the build folder.
namespace fulbito {
using namespace test;
namespace {

void write(const Result<Canvas>& canvas, const std::string& name) {
  REQUIRE(canvas);
  std::filesystem::create_directories(FULBITO_GALLERY);
  const auto written = canvas->writePng(FULBITO_GALLERY "/" + name + ".png");
  REQUIRE(written);
}

const char* const kNames[] = {"straight",      "bezier",      "hermite", "b-spline",     "univector",
                              "tangent-field", "dwa",         "vfh",     "pure-pursuit", "stanley",
                              "potential",     "limit-cycle", "rrt",     "a-star",       "dubins",
                              "teb",           "orca",        "bug2",    "follow-gap",   "clothoid"};

void addPaths(FieldPicture& picture, int count) {
  for (int i = 0; i < count; ++i) {
    picture.paths.push_back(samplePath(picture.layout, kNames[i], (i % 2 == 0 ? 0.045 : -0.045) * (i / 2 + 1),
                                       i % 3 == 0 ? 0.012 : 0.0));
  }
}

BarChart sampleChart(int groups, int bars) {
  BarChart chart{"Time of safe runs over the bound",
                 "median time / T*  (bars: 95 % interval)",
                 {},
                 1.0,
                 true,
                 "T* (bound)"};
  for (int g = 0; g < groups; ++g) {
    BarGroup group{fmt::format("top speed {:.1f} m/s", 0.5 * (g + 1)), {}};
    for (int i = 0; i < bars; ++i) {
      const double value = 1.05 + 0.07 * i + 0.1 * g;
      group.bars.push_back({kNames[i], value, value - 0.04, value + 0.03 + 0.01 * i,
                            i == 3 ? "12 collisions" : "", static_cast<std::size_t>(i)});
    }
    if (bars > 4) group.bars[4] = {kNames[4], std::nan(""), 0, 0, "no safe run", 4};
    chart.groups.push_back(group);
  }
  return chart;
}

}  // namespace

TEST_CASE("gallery: the corner problem", "[.][gallery]") {
  FieldPicture picture = cornerPicture();
  picture.layout.goal_heading = 0.0;
  addPaths(picture, 9);
  addFootprints(picture.paths[1], 24);
  picture.paths[6].failed = true;
  picture.paths[6].remark = "collided at 0.92 s";
  picture.paths[6].points.resize(60);
  write(drawFieldPicture(picture), "corner");
}

TEST_CASE("gallery: five against five with every kind of obstacle", "[.][gallery]") {
  FieldPicture picture;
  picture.title = "A moving ball, a box and one that can be pushed";
  picture.field = {"vsss-5v5", 2.2, 1.8, 0.4, 0.15, 0.07, 0.05, 0.5, 0.15, 0.25, 0.725};
  picture.layout.start = {{-0.9, 0.1}, 0.0};
  picture.layout.goal = {0.9, -0.2};
  picture.layout.obstacles = {disc({-0.3, 0.2}), disc({-0.1, -0.5}), disc({0.3, 0.1}), disc({0.4, -0.5}),
                              disc({0.0, 0.45})};
  picture.layout.obstacles[1].motion = ObstacleMotion::kPath;
  picture.layout.obstacles[1].path = {{-0.1, -0.5}, {0.1, -0.1}, {-0.1, 0.2}};
  picture.layout.obstacles[2].shape = ObstacleShape::kBox;
  picture.layout.obstacles[2].pose.heading = 0.4;
  picture.layout.obstacles[3].motion = ObstacleMotion::kPushable;
  picture.layout.obstacles[4].motion = ObstacleMotion::kPath;
  picture.layout.obstacles[4].path = {{0.0, 0.45}, {0.5, 0.45}, {0.5, 0.7}, {0.0, 0.7}};
  picture.layout.obstacles[4].path_end = PathEnd::kCycle;
  addPaths(picture, 4);
  addFootprints(picture.paths[0], 20);
  write(drawFieldPicture(picture), "five");
}

TEST_CASE("gallery: twenty paths with long labels, some on each other", "[.][gallery]") {
  FieldPicture picture = cornerPicture();
  addPaths(picture, 20);
  for (std::size_t i = 14; i < 20; ++i) picture.paths[i].points = picture.paths[2].points;
  picture.paths[5].label = "a navigator with a really long name that cannot fit beside its remark";
  picture.paths[7].remark = "a remark that goes on and on without an end in sight, and then some more";
  picture.paths[9].failed = true;
  write(drawFieldPicture(picture), "twenty");
}

TEST_CASE("gallery: a bundle of six equal paths", "[.][gallery]") {
  FieldPicture picture = cornerPicture();
  for (int i = 0; i < 6; ++i) picture.paths.push_back(samplePath(picture.layout, kNames[i], 0.2 + 0.001 * i));
  picture.paths[3].failed = true;
  write(drawFieldPicture(picture), "bundle");
}

TEST_CASE("gallery: small plain field", "[.][gallery]") {
  FieldPicture picture = cornerPicture();
  picture.field = {"plain", 1.0, 0.5, 0.0, 0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.0};
  picture.layout.start.position = {-0.4, -0.1};
  picture.layout.goal = {0.4, 0.1};
  picture.pixels_per_metre = 300;
  addPaths(picture, 3);
  write(drawFieldPicture(picture), "plain");
}

TEST_CASE("gallery: bar charts", "[.][gallery]") {
  write(drawBarChart(sampleChart(3, 9)), "bars");
  write(drawBarChart(sampleChart(1, 2)), "bars-small");
  BarChart negative = sampleChart(1, 4);
  for (Bar& bar : negative.groups[0].bars) {
    bar.value = 100 * (bar.value - 1.15), bar.low = bar.value - 3, bar.high = bar.value + 3;
  }
  negative.has_reference = false;
  write(drawBarChart(negative), "bars-negative");
}

}  // namespace fulbito
