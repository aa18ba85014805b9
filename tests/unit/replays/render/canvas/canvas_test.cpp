#include "fulbito/detail/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <thread>

#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

constexpr Colour kPaper{10, 20, 30}, kRed{250, 0, 0};

Canvas canvas(int width = 100, int height = 100) { return *Canvas::create(width, height, kPaper); }

/// Sets FULBITO_FONT for the lifetime of this object.
class FontOverride {
 public:
  explicit FontOverride(const char* file) {
    if (const char* before = std::getenv("FULBITO_FONT")) before_ = before;
    setenv("FULBITO_FONT", file, 1);
  }
  FontOverride(const FontOverride&) = delete;
  FontOverride& operator=(const FontOverride&) = delete;
  ~FontOverride() {
    if (before_) {
      setenv("FULBITO_FONT", before_->c_str(), 1);
    } else {
      unsetenv("FULBITO_FONT");
    }
  }

 private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("a new canvas has its size and background", "[unit]") {
  const Canvas paper = canvas(40, 30);
  CHECK(paper.width() == 40);
  CHECK(paper.height() == 30);
  CHECK(count(paper, kPaper) == 40 * 30);
  CHECK(paper.pixel(40, 0).a == 0);
  CHECK(paper.pixel(0, -1).a == 0);
}

TEST_CASE("impossible sizes are refused with the limits", "[unit]") {
  for (auto [width, height] : {std::pair{0, 10}, {10, 0}, {-5, 10}, {16385, 1}, {16000, 16000}}) {
    const auto refused = Canvas::create(width, height, kPaper);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::kUsage);
    CHECK_THAT(refused.error().message,
               Catch::Contains(std::to_string(width) + " x " + std::to_string(height)));
    CHECK_THAT(refused.error().message, Catch::Contains("16384") && Catch::Contains("64 million"));
  }
  CHECK(Canvas::create(16384, 1, kPaper));
}

TEST_CASE("a missing font is an error that names it and the remedy", "[unit]") {
  const FontOverride none("/nowhere/no-such-font.ttf");
  const auto refused = Canvas::create(10, 10, kPaper);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::kIo);
  CHECK_THAT(refused.error().message, Catch::Contains("/nowhere/no-such-font.ttf"));
  CHECK_THAT(refused.error().message,
             Catch::Contains("fonts-dejavu-core") && Catch::Contains("FULBITO_FONT"));
}

TEST_CASE("no display is needed", "[unit]") {
  unsetenv("DISPLAY");
  setenv("SDL_VIDEODRIVER", "no-such-driver", 1);
  CHECK(Canvas::create(10, 10, kPaper));
  unsetenv("SDL_VIDEODRIVER");
}

TEST_CASE("a rectangle fills its pixels and shares those at its edges", "[unit]") {
  Canvas paper = canvas();
  paper.fillRectangle({10, 20}, 5.5, 4, {210, 220, 230});
  CHECK(count(paper, {210, 220, 230}) == 5 * 4);
  CHECK(same(paper.pixel(15, 20), {110, 120, 130}));
  CHECK(same(paper.pixel(16, 20), kPaper));
  CHECK(same(paper.pixel(9, 20), kPaper));
}

TEST_CASE("a disc has the area of a circle", "[unit]") {
  Canvas paper = *Canvas::create(100, 100, {0, 0, 0});
  paper.fillCircle({50.3, 49.6}, 20.0, {255, 255, 255});
  double area = 0.0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) area += paper.pixel(x, y).r / 255.0;
  }
  CHECK(area == Approx(math::kPi * 400.0).epsilon(0.002));
  CHECK(paper.pixel(50, 49).r == 255);
  CHECK(paper.pixel(50, 28).r == 0);
}

TEST_CASE("a ring leaves its inside", "[unit]") {
  Canvas paper = canvas();
  paper.circle({50, 50}, 20, 4, kRed);
  CHECK(same(paper.pixel(50, 50), kPaper));
  CHECK(same(paper.pixel(70, 50), kRed));
  CHECK(same(paper.pixel(50, 29), kRed));
  CHECK(same(paper.pixel(50, 26), kPaper));
}

TEST_CASE("a slanted stroke has the area of its length and thickness", "[unit]") {
  Canvas paper = *Canvas::create(300, 300, {0, 0, 0});
  paper.line({20, 30}, {270, 180}, 5.0, {255, 255, 255});
  double area = 0.0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) area += paper.pixel(x, y).r / 255.0;
  }
  const double length = std::sqrt(250.0 * 250.0 + 150.0 * 150.0);
  CHECK(area == Approx(5.0 * length + math::kPi * 2.5 * 2.5).epsilon(0.005));
}

TEST_CASE("a hair line is fainter than a full one", "[unit]") {
  Canvas paper = *Canvas::create(20, 20, {0, 0, 0});
  paper.line({0, 10.5}, {20, 10.5}, 0.5, {200, 200, 200});
  CHECK(paper.pixel(10, 10).r == Approx(100).margin(2));
  CHECK(paper.pixel(10, 11).r == 0);
}

TEST_CASE("a concave polygon keeps its notch", "[unit]") {
  Canvas paper = canvas();
  const std::array<Vec2, 5> arrow{Vec2{10, 10}, Vec2{90, 50}, Vec2{10, 90}, Vec2{50, 50}, Vec2{49, 49}};
  paper.fillPolygon(arrow, kRed);
  CHECK(same(paper.pixel(30, 25), kRed));
  CHECK(same(paper.pixel(80, 50), kRed));
  CHECK(same(paper.pixel(30, 75), kRed));
  CHECK(same(paper.pixel(30, 50), kPaper));
}

TEST_CASE("a translucent path does not darken where it crosses itself", "[unit]") {
  Canvas paper = *Canvas::create(100, 100, {0, 0, 0});
  const std::array<Vec2, 4> loop{Vec2{10, 50}, Vec2{90, 50}, Vec2{50, 10}, Vec2{50, 90}};
  paper.polyline(loop, 6, {200, 200, 200, 128});
  CHECK(same(paper.pixel(50, 50), paper.pixel(30, 50)));
  CHECK(paper.pixel(30, 50).r == Approx(100).margin(1));
}

TEST_CASE("what lies outside or is not finite is left out", "[unit]") {
  Canvas paper = canvas();
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (double bad : {inf, -inf, nan, 1e300, 1e7}) {
    const std::array<Vec2, 3> points{Vec2{10, 10}, Vec2{bad, 20}, Vec2{20, bad}};
    paper.polyline(points, 3, kRed);
    paper.fillPolygon(points, kRed);
    paper.fillCircle({bad, 5}, 3, kRed);
    paper.circle({5, 5}, bad, 3, kRed);
    paper.line({5, 5}, {50, 50}, bad, kRed);
    paper.fillRectangle({bad, bad}, 10, 10, kRed);
    paper.text({bad, 10}, "far", 14, kRed);
  }
  paper.fillRectangle({10, 10}, -5, 5, kRed);
  paper.fillCircle({50, 50}, -3, kRed);
  paper.fillCircle({-500, 50}, 30, kRed);
  paper.text({5000, 50}, "outside", 14, kRed);
  CHECK(count(paper, kPaper) == 100 * 100);
}

TEST_CASE("shapes are cut at the edge of the picture", "[unit]") {
  Canvas paper = canvas();
  paper.fillRectangle({-50, -50}, 60, 60, kRed);
  paper.line({90, -1000}, {90, 1000}, 2, kRed);
  CHECK(count(paper, kRed, 0, 0, 50, 50) == 100);
  CHECK(count(paper, kRed, 50, 0, 100, 100) == 200);
}

TEST_CASE("text stands on its baseline and keeps its alignment", "[unit]") {
  const double width = canvas().textWidth("HHHH", 20);
  CHECK(width > 40);
  CHECK(width < 80);
  for (auto [align, left] : {std::pair{TextAlign::kLeft, 100.0},
                             {TextAlign::kCentre, 100.0 - width / 2},
                             {TextAlign::kRight, 100.0 - width}}) {
    Canvas paper = canvas(200, 60);
    paper.text({100, 40}, "HHHH", 20, kRed, align);
    const int from = static_cast<int>(left), to = static_cast<int>(left + width) + 1;
    CHECK(count(paper, kRed, from, 20, to, 40) > 50);
    CHECK(count(paper, kPaper, from, 41, to, 60) == (to - from) * 19);
    CHECK(count(paper, kPaper, 0, 0, from, 60) == from * 60);
    CHECK(count(paper, kPaper, to, 0, 200, 60) == (200 - to) * 60);
  }
}

TEST_CASE("odd texts are harmless", "[unit]") {
  Canvas paper = canvas(300, 60);
  for (const std::string& text : {std::string(), std::string("\n\t"), std::string("\xff\xfe broken \xc3"),
                                  std::string("nul\0within", 10), std::string("\u00d7 \u4f60")}) {
    paper.text({10, 30}, text, 14, kRed);
    CHECK(paper.textWidth(text, 14) >= 0.0);
  }
  CHECK(paper.textWidth("a\nb", 14) == paper.textWidth("a b", 14));
  CHECK(paper.textWidth("a", -3) > 0.0);
  CHECK(paper.textWidth("a", std::nan("")) >= 0.0);
}

TEST_CASE("canvases in several threads give the pixels that one gives", "[unit]") {
  const auto draw = [] {
    Canvas paper = canvas(200, 100);
    for (int i = 0; i < 20; ++i) {
      paper.text({10, 20.0 + 4 * i}, "thread " + std::to_string(i), 10 + i, kRed);
      paper.line({0, 0}, {200, 5.0 * i}, 2, {0, 200, 0, 100});
    }
    return paper;
  };
  const Canvas alone = draw();
  std::array<bool, 4> matches{};
  std::vector<std::thread> threads;
  for (bool& match : matches) {
    threads.emplace_back([&] {
      match = true;
      for (int i = 0; i < 5; ++i) match = match && equal(draw(), alone);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (bool match : matches) CHECK(match);
}

TEST_CASE("a convex polygon is the same as any polygon, but for its corners", "[unit]") {
  for (int turn = 0; turn < 40; ++turn) {
    std::vector<Vec2> points;
    for (int corner = 0; corner < 3 + turn % 6; ++corner) {
      const double angle = 0.17 * turn + 6.283185307179586 * corner / (3 + turn % 6);
      points.push_back(Vec2{50.3, 49.8} + Vec2{std::cos(angle), std::sin(angle)} * (3.0 + turn));
    }
    if (turn % 2 == 1) std::reverse(points.begin(), points.end());
    Canvas quick = canvas(), slow = canvas();
    quick.fillConvex(points, kRed);
    slow.fillPolygon(points, kRed);
    int far = 0, near = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const int off = std::abs(quick.pixel(x, y).r - slow.pixel(x, y).r);
        far += off > 100 ? 1 : 0;
        near += off > 3 ? 1 : 0;
      }
    }
    INFO("turn " << turn);
    CHECK(far == 0);
    CHECK(near <= 6 * static_cast<int>(points.size()));
  }
}

}  // namespace fulbito
