#include "fulbito/picture.hpp"
#include "replays/render/colours/palette.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

// At 600 pixels per metre, the 3v3 field with walls and goals has 1050 x 810 pixels; its corner is at (26,
// 84).
constexpr int kLeft = 26, kTop = 84, kRight = kLeft + 1050, kBottom = kTop + 810, kLegend = kRight + 26;

struct Pixel {
  int x, y;
};

/// The pixel of a world point in that picture.
Pixel at(Vec2 world) {
  return {static_cast<int>(kLeft + 525 + 600 * world.x), static_cast<int>(kTop + 405 - 600 * world.y)};
}

Colour colourAt(const Canvas& canvas, Vec2 world) { return canvas.pixel(at(world).x, at(world).y); }

/// The number of pixels of this colour around a world point.
int countAround(const Canvas& canvas, Vec2 world, double reach, Colour colour) {
  const Pixel low = at(world - Vec2{reach, -reach}), high = at(world + Vec2{reach, -reach});
  return count(canvas, colour, low.x, low.y, high.x, high.y);
}

Canvas drawn(const FieldPicture& picture) {
  auto canvas = drawFieldPicture(picture);
  REQUIRE(canvas);
  return std::move(*canvas);
}

FieldPicture emptyPicture() {
  FieldPicture picture;
  picture.layout.start = {{-0.5, 0.3}, 0.0};
  picture.layout.goal = {0.5, 0.3};
  return picture;
}

}  // namespace

TEST_CASE("the field has its lines, walls, corner triangles and goals", "[unit]") {
  const Canvas canvas = drawn(emptyPicture());
  CHECK(same(colourAt(canvas, {0.25, -0.3}), theme::kFloor));
  for (Vec2 on_line : {Vec2{0, 0.5}, Vec2{0, -0.5}, Vec2{0.2, 0}, Vec2{-0.2, 0}, Vec2{0.75, 0.3},
                       Vec2{-0.75, 0}, Vec2{0.6, 0.1}, Vec2{-0.7, 0.35}, Vec2{0.5, 0.65}, Vec2{0.375, 0},
                       Vec2{-0.375, 0}, Vec2{0, 0}, Vec2{0.85, 0.1}, Vec2{-0.8, -0.2}, Vec2{0.715, 0.615}}) {
    CAPTURE(on_line.x, on_line.y);
    CHECK(same(colourAt(canvas, on_line), theme::kFieldLine));
  }
  for (Vec2 wall : {Vec2{0.3, 0.665}, Vec2{-0.765, 0.4}, Vec2{0.735, 0.635}, Vec2{-0.735, -0.635},
                    Vec2{0.8, 0.215}, Vec2{-0.865, 0}}) {
    CAPTURE(wall.x, wall.y);
    CHECK(same(colourAt(canvas, wall), theme::kWall));
  }
  CHECK(same(colourAt(canvas, {0.8, 0.5}), theme::kPage));
}

TEST_CASE("areas have their arcs, and free balls their marks", "[unit]") {
  const Canvas canvas = drawn(emptyPicture());
  // The arc's chord is 20 cm long, on the area's front line; its foremost point is 5 cm in front of that
  // line.
  for (Vec2 on_line :
       {Vec2{0.55, 0}, Vec2{-0.55, 0}, Vec2{0.375, 0.4}, Vec2{-0.375, -0.4}, Vec2{0.375, -0.39}}) {
    CAPTURE(on_line.x, on_line.y);
    CHECK(same(colourAt(canvas, on_line), theme::kFieldLine));
  }
  CHECK(same(colourAt(canvas, {0.575, 0}), theme::kFloor));
  CHECK(same(colourAt(canvas, {0.55, 0.1}), theme::kFloor));
  FieldPicture picture = emptyPicture();
  picture.field.goal_area_arc_width = 0.0;
  picture.field.big_area_width = 1.0;
  picture.field.big_area_depth = 0.3;
  picture.field.free_ball_mark = {};
  const Canvas big = drawn(picture);
  CHECK(same(colourAt(big, {0.45, 0.2}), theme::kFieldLine));
  CHECK(same(colourAt(big, {0.6, -0.5}), theme::kFieldLine));
  CHECK(same(colourAt(big, {0.55, 0}), theme::kFloor));
  CHECK(same(colourAt(big, {-0.375, 0.4}), theme::kFloor));
}

TEST_CASE("a rectangle without goals and corners has a plain border", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.field = {"plain", 1.5, 1.3, 0, 0, 0, 0.05, 0, 0, 0, 0};
  const Canvas canvas = drawn(picture);
  // Without goals, the field's centre is 60 pixels farther left.
  const int x = kLeft + 465;
  CHECK(same(canvas.pixel(x + 445, kTop + 20), theme::kFloor));
  CHECK(same(canvas.pixel(x + 450, kTop + 405), theme::kFieldLine));
  CHECK(same(canvas.pixel(x + 460, kTop + 405), theme::kWall));
  CHECK(same(canvas.pixel(x + 100, kTop + 405), theme::kFloor));
}

TEST_CASE("obstacles have their shape, place and tint", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.layout.obstacles = {disc({-0.2, -0.3}), disc({0.3, -0.3}), disc({0.5, -0.1})};
  picture.layout.obstacles[1].motion = ObstacleMotion::kPushable;
  picture.layout.obstacles[2].shape = ObstacleShape::kBox;
  picture.layout.obstacles[2].pose.heading = math::kPi / 4;
  const Canvas canvas = drawn(picture);
  CHECK(same(colourAt(canvas, {-0.2, -0.3}), theme::kTennisBall));
  CHECK(same(colourAt(canvas, {0.3, -0.3}), theme::kPushable));
  CHECK_FALSE(same(colourAt(canvas, {-0.2 + 0.031, -0.3}), theme::kFloor));
  CHECK(same(colourAt(canvas, {-0.2 + 0.037, -0.3}), theme::kFloor));
  CHECK_FALSE(same(colourAt(canvas, {0.5 + 0.048, -0.1}), theme::kFloor));
  CHECK(same(colourAt(canvas, {0.5 + 0.035, -0.1 + 0.035}), theme::kFloor));
}

TEST_CASE("a moving obstacle has a dashed path with an arrow", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.layout.obstacles = {disc({-0.5, -0.4})};
  const int still = countAround(drawn(picture), {-0.2, -0.4}, 0.2, theme::kTennisBall);
  CHECK(still == 0);
  picture.layout.obstacles[0].motion = ObstacleMotion::kPath;
  picture.layout.obstacles[0].path = {{-0.5, -0.4}, {-0.1, -0.4}};
  const Canvas canvas = drawn(picture);
  const int head = countAround(canvas, {-0.11, -0.4}, 0.012, theme::kTennisBall);
  CHECK(head > 30);
  int on = 0, off = 0;
  for (double x = -0.4; x < -0.2; x += 1.0 / 600) {
    (same(colourAt(canvas, {x, -0.4}), theme::kFloor) ? off : on) += 1;
  }
  CHECK(on > 50);
  CHECK(off > 20);
}

TEST_CASE("the start shows the body and the goal its tolerance", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.layout.goal_tolerance = 0.05;
  const Canvas canvas = drawn(picture);
  CHECK(same(colourAt(canvas, {-0.5 + 0.0375, 0.33}), theme::kMarker));
  CHECK(same(colourAt(canvas, {-0.5 - 0.0375, 0.27}), theme::kMarker));
  CHECK(same(colourAt(canvas, {-0.5, 0.3}), theme::kMarker));
  CHECK(same(colourAt(canvas, {0.5, 0.3}), theme::kMarker));
  for (Vec2 side : {Vec2{0.05, 0}, Vec2{0, -0.05}}) CHECK(colourAt(canvas, Vec2{0.5, 0.3} + side).r > 180);
  CHECK(same(colourAt(canvas, {0.56, 0.3}), theme::kFloor));
}

TEST_CASE("a wanted heading is an arrow at the goal", "[unit]") {
  FieldPicture picture = emptyPicture();
  const Vec2 above = picture.layout.goal + Vec2{0, 0.05};
  CHECK(countAround(drawn(picture), above, 0.01, theme::kMarker) == 0);
  picture.layout.goal_heading = math::kPi / 2;
  CHECK(countAround(drawn(picture), above, 0.01, theme::kMarker) > 10);
}

TEST_CASE("a path runs through its points in its colour", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "a", 0.2), samplePath(picture.layout, "b", -0.3)};
  const Canvas canvas = drawn(picture);
  for (std::size_t i = 0; i < 2; ++i) {
    int hits = 0;
    for (std::size_t k = 20; k <= 100; k += 4) {
      hits += same(colourAt(canvas, picture.paths[i].points[k]), seriesColour(i)) ? 1 : 0;
    }
    CAPTURE(i);
    CHECK(hits >= 18);  // of 21 points; a badge may cover some
  }
}

TEST_CASE("paths on each other all show their colour", "[unit]") {
  FieldPicture picture = emptyPicture();
  for (int i = 0; i < 8; ++i) picture.paths.push_back(samplePath(picture.layout, "same", -0.3));
  picture.paths[5].failed = true;
  const Canvas canvas = drawn(picture);
  int alone = 0;
  for (Vec2 p : picture.paths[0].points) alone += same(colourAt(canvas, p), seriesColour(0)) ? 1 : 0;
  CHECK(alone < 40);  // of 121 points
  for (std::size_t i = 0; i < 8; ++i) {
    CAPTURE(i);
    // More pixels than its badge has.
    CHECK(count(canvas, seriesColour(i), kLeft, kTop, kRight, kBottom) > 150 + 60);
  }
}

TEST_CASE("a failed path is dashed and crossed out at its end", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "a", -0.3)};
  picture.paths[0].points.resize(80);
  const Vec2 end = picture.paths[0].points.back();
  const Colour colour = seriesColour(0);
  const Canvas whole = drawn(picture);
  picture.paths[0].failed = true;
  const Canvas failed = drawn(picture);
  const auto painted = [&](const Canvas& canvas) {
    int hits = 0;
    for (Vec2 p : picture.paths[0].points) hits += same(colourAt(canvas, p), colour) ? 1 : 0;
    return hits;
  };
  CHECK(painted(whole) > 70);  // of 80 points
  CHECK(painted(failed) < 62);
  CHECK(painted(failed) > 35);
  const Vec2 arm{0.01, -0.01};
  for (Vec2 tip : {end + arm, end - arm, end + perp(arm), end - perp(arm)}) {
    CHECK(same(colourAt(failed, tip), colour));
  }
}

TEST_CASE("a touch is marked where it was, and a run that arrived all the same has no cross at its end",
          "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "a", -0.3)};
  picture.paths[0].points.resize(80);
  const Vec2 end = picture.paths[0].points.back(), touch{0.1, -0.4}, arm{0.01, -0.01};
  picture.paths[0].failed = picture.paths[0].arrived = true;
  CHECK_FALSE(same(colourAt(drawn(picture), end + arm), seriesColour(0)));
  CHECK(countAround(drawn(picture), touch, 0.01, seriesColour(0)) == 0);
  picture.paths[0].touches = {touch};
  const Canvas marked = drawn(picture);
  CHECK(same(colourAt(marked, touch), seriesColour(0)));
  CHECK(countAround(marked, touch, 0.02, theme::kMarker) > 30);
}

TEST_CASE("paths can share a colour, and the hollow one has a dark core", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "a", 0.2), samplePath(picture.layout, "b", -0.3)};
  picture.paths[1].colour = 0;
  picture.paths[1].hollow = true;
  const Canvas canvas = drawn(picture);
  CHECK(count(canvas, seriesColour(1), kLeft, kTop, kRight, kBottom) == 0);
  int core = 0;
  for (Vec2 p : picture.paths[1].points) core += same(colourAt(canvas, p), theme::kPage) ? 1 : 0;
  CHECK(core > 20);
}

TEST_CASE("a window shows a part of the field, larger", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.layout.obstacles = {disc({0.1, 0.1})};
  picture.window = FieldWindow{{0.0, 0.0}, {0.3, 0.2}};
  picture.pixels_per_metre = 2000;
  const Canvas canvas = drawn(picture);
  // The window has 600 x 400 pixels. The ball's centre is 200 pixels from the left and 200 from the bottom.
  const auto ball = [&](int x, int y) { return same(canvas.pixel(x, y), theme::kTennisBall); };
  const double unit = 0.8;
  const int left = static_cast<int>(26 * unit), top = static_cast<int>(84 * unit);
  CHECK(ball(left + 200 + 15, top + 200));
  CHECK_FALSE(ball(left + 200 + 80, top + 200));
  // A path that leaves the window has its number inside.
  picture.paths = {samplePath(picture.layout, "long", 0.0)};
  picture.window = FieldWindow{{-0.5, 0.2}, {-0.4, 0.4}};
  const Canvas start = drawn(picture);
  CHECK(count(start, theme::kPage, left + 20, top + 20, left + 180, top + 380) > 4);  // pixels of the number
  picture.window = FieldWindow{{0.1, 0.0}, {0.1, 0.2}};
  CHECK(drawFieldPicture(picture).error().code == ErrorCode::kUsage);
}

TEST_CASE("a caption makes room above the field and arrows lie on it", "[unit]") {
  FieldPicture picture = emptyPicture();
  const int height = drawn(picture).height();
  picture.caption = "What the paper's figure shows.";
  CHECK(drawn(picture).height() > height + 15);
  picture.caption.clear();
  const Vec2 place{0.2, -0.3};
  CHECK(same(colourAt(drawn(picture), place), theme::kFloor));
  picture.arrows = {"the field", 0.04, {Pose2{place, 0.0}}};
  CHECK_FALSE(same(colourAt(drawn(picture), place), theme::kFloor));
  CHECK(same(colourAt(drawn(picture), place + Vec2{0.0, 0.03}), theme::kFloor));
}

TEST_CASE("a name that is too long for a row takes more lines and is not cut", "[unit]") {
  FieldPicture picture = emptyPicture();
  const auto ink = [&](const std::string& label) {
    picture.paths = {samplePath(picture.layout, label, 0.1)};
    const Canvas canvas = drawn(picture);
    return count(canvas, theme::kText, kLegend, kTop, canvas.width(), canvas.height());
  };
  const int method = ink("vector-field:offset=0.10,width=0.20,follow"),
            whole = ink("vector-field:offset=0.10,width=0.20,follower=classic");
  CHECK(whole > method);  // the letters that the shorter name lacks are drawn
}

TEST_CASE("a failed path keeps its gaps among twenty", "[unit]") {
  FieldPicture picture = emptyPicture();
  for (int i = 0; i < 20; ++i) picture.paths.push_back(samplePath(picture.layout, "path", -0.03 * i));
  picture.paths[19].failed = true;
  const Canvas canvas = drawn(picture);
  int gaps = 0;
  for (Vec2 p : picture.paths[19].points) gaps += same(colourAt(canvas, p), seriesColour(19)) ? 0 : 1;
  CHECK(gaps > 25);  // of 121 points
  CHECK(gaps < 80);
}

TEST_CASE("footprints outline the body on the way", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "a", 0.0)};
  const Vec2 edge{0.25, 0.3 + 0.0375};
  CHECK(same(colourAt(drawn(picture), edge), theme::kFloor));
  picture.paths[0].footprints = {{{0.25, 0.3}, 0.0}};
  CHECK_FALSE(same(colourAt(drawn(picture), edge), theme::kFloor));
}

TEST_CASE("the legend stands beside the field and has a row for each path", "[unit]") {
  FieldPicture picture = cornerPicture();
  for (int i = 0; i < 5; ++i) picture.paths.push_back(samplePath(picture.layout, "path", 0.1 * i));
  const Canvas canvas = drawn(picture);
  CHECK(count(canvas, theme::kPage, kRight, kTop, kLegend, kBottom) == (kLegend - kRight) * (kBottom - kTop));
  CHECK(count(canvas, theme::kPanel, kLeft, kTop, kRight, kBottom) == 0);
  CHECK(same(canvas.pixel(kLegend + 2, kTop + 2), theme::kPanel));
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(count(canvas, seriesColour(i), kLegend, kTop, canvas.width(), kBottom) > 150);
  }
  CHECK(count(canvas, seriesColour(5), kLegend, kTop, canvas.width(), kBottom) == 0);
  CHECK(count(canvas, theme::kText, kLegend, kTop, canvas.width(), kBottom) > 100);
}

TEST_CASE("paths and obstacles outside of the field do not reach header, legend or page", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.paths = {samplePath(picture.layout, "wild", 0.0)};
  const Canvas tame = drawn(picture);
  picture.paths[0].points.insert(picture.paths[0].points.begin() + 60,
                                 {{0, 5}, {3, 0}, {0, -5}, {-9, 0}, {0, 0}});
  picture.paths[0].points[30] = {std::nan(""), 0.0};
  picture.layout.obstacles = {disc({0.9, 0.0})};
  const Canvas wild = drawn(picture);
  CHECK_FALSE(equal(wild, tame));
  int outside = 0;
  for (int y = 0; y < tame.height(); ++y) {
    for (int x = 0; x < kLegend; ++x) {
      if (x >= kLeft && x < kRight && y >= kTop && y < kBottom) continue;
      outside += same(tame.pixel(x, y), wild.pixel(x, y)) ? 0 : 1;
    }
  }
  CHECK(outside == 0);
}

TEST_CASE("the scale bar is a tenth of a metre long", "[unit]") {
  const Canvas canvas = drawn(emptyPicture());
  int longest = 0, run = 0;
  for (int y = kBottom; y < canvas.height(); ++y, run = 0) {
    for (int x = 0; x < kRight; ++x) {
      run = same(canvas.pixel(x, y), theme::kText) ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  CHECK(longest == Approx(60).margin(3));
}

TEST_CASE("twenty paths with endless labels fit", "[unit]") {
  FieldPicture picture = cornerPicture();
  picture.title = std::string(2000, 'W');
  for (int i = 0; i < 20; ++i) {
    picture.paths.push_back(samplePath(picture.layout, std::string(300, 'W'), 0.03 * (i - 10)));
    picture.paths.back().remark = std::string(300, 'M');
  }
  const Canvas canvas = drawn(picture);
  // The outer margins stay empty.
  CHECK(count(canvas, theme::kPage, canvas.width() - 26, 0, canvas.width(), canvas.height()) ==
        26 * canvas.height());
  CHECK(count(canvas, theme::kPanel, canvas.width() - 46, kTop, canvas.width() - 26, kTop + 100) == 20 * 100);
  CHECK(count(canvas, theme::kPage, kLegend, canvas.height() - 26, canvas.width(), canvas.height()) ==
        26 * (canvas.width() - kLegend));
}

TEST_CASE("a picture without obstacles and paths, and one with empty paths, can be drawn", "[unit]") {
  CHECK(drawFieldPicture(FieldPicture{}));
  FieldPicture picture = emptyPicture();
  picture.paths = {DrawnPath{}, DrawnPath{"one point", "", {{0, 0}}, {}, true}};
  picture.layout.obstacles = {disc({std::nan(""), 0.0})};
  picture.layout.obstacles[0].motion = ObstacleMotion::kPath;
  picture.layout.obstacles.push_back(disc({0, 0}));
  picture.layout.obstacles[1].radius = -1.0;
  CHECK(drawFieldPicture(picture));
}

TEST_CASE("a small picture still has a whole legend", "[unit]") {
  FieldPicture picture = emptyPicture();
  picture.pixels_per_metre = 60;
  for (int i = 0; i < 6; ++i) picture.paths.push_back(samplePath(picture.layout, "path", 0.1 * i));
  const Canvas canvas = drawn(picture);
  for (std::size_t i = 0; i < 6; ++i) CHECK(count(canvas, seriesColour(i)) > 100);
}

TEST_CASE("the same picture gives the same pixels", "[unit]") {
  FieldPicture picture = cornerPicture();
  picture.paths = {samplePath(picture.layout, "a", 0.2), samplePath(picture.layout, "b", -0.1)};
  CHECK(equal(drawn(picture), drawn(picture)));
}

TEST_CASE("impossible pictures are refused", "[unit]") {
  FieldPicture picture;
  picture.pixels_per_metre = 0;
  CHECK(drawFieldPicture(picture).error().code == ErrorCode::kUsage);
  picture.pixels_per_metre = 100000;
  const auto huge = drawFieldPicture(picture);
  REQUIRE_FALSE(huge);
  CHECK(huge.error().code == ErrorCode::kUsage);
  CHECK_THAT(huge.error().message, Catch::Contains("lower pixels_per_metre") && Catch::Contains("million"));
  picture.pixels_per_metre = 600;
  picture.field.width = std::nan("");
  CHECK_FALSE(drawFieldPicture(picture));
  picture.field = FieldGeometry{};
  picture.field.corner = 5.0;
  CHECK(drawFieldPicture(picture).error().code == ErrorCode::kBadInput);
}

}  // namespace fulbito
