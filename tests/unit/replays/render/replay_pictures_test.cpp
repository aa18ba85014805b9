#include "engine/core/base/xml_text.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/colours/heat_colours.hpp"
#include "replays/render/match/svg_field.hpp"
#include "tests/support/sample_replay.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

using namespace test;

MatchPictureSpec specOf(const ReplayTimeline& timeline, int width = 450) {
  auto spec = pictureSpecOf(timeline);
  REQUIRE(spec);
  spec->width = width;
  return std::move(*spec);
}

double lightness(Colour c) { return 0.2126 * c.r * c.r + 0.7152 * c.g * c.g + 0.0722 * c.b * c.b; }

}  // namespace

TEST_CASE("a recording says itself what its pictures need", "[unit]") {
  const MatchPictureSpec spec = specOf(sampleReplay());
  CHECK(spec.names == PerTeam<std::string>{"libero", "classic"});
  CHECK(spec.bodies.size() == 5);
  CHECK(spec.seconds == 20.0);
  REQUIRE(spec.goals.size() == 1);
  CHECK(spec.goals[0].seconds == 8.0);
  CHECK(spec.field.length == 1.5);
}

TEST_CASE("heat goes one way from dark to light, or from light to dark", "[unit]") {
  for (const PictureTheme theme : {PictureTheme::kDark, PictureTheme::kLight}) {
    const auto colours = heatColours(theme);
    const double sign = theme == PictureTheme::kDark ? 1.0 : -1.0;
    for (std::size_t i = 4; i < colours.size(); ++i) {
      CHECK(sign * (lightness(colours[i]) - lightness(colours[i - 4])) > 0.0);
    }
  }
}

TEST_CASE("a heat map is hot where the ball was", "[unit]") {
  const ReplayTimeline timeline = sampleReplay();
  const auto picture = MatchPicture::create(specOf(timeline));
  const auto map = drawHeatMap(timeline, specOf(timeline), {{4}, "the ball", 0.0, 20.0});
  REQUIRE(map);
  const auto heat = [&](Vec2 place) {
    const Vec2 pixel = pixelOf(*picture, place);
    return lightness(map->pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y)));
  };
  CHECK(heat({0.3, 0.1}) > 4.0 * heat({0.3, -0.3}));
  CHECK(heat({0.3, 0.1}) > 4.0 * heat({-0.3, 0.1}));
  // Without any body in the selection there is no heat, and no division by zero.
  CHECK(drawHeatMap(timeline, specOf(timeline), {{}, "nobody", 0.0, 20.0}));
  CHECK(drawHeatMap(timeline, specOf(timeline), {{4}, "the ball", 8.5, 8.6}));
}

TEST_CASE("a contact sheet has a picture for each time", "[unit]") {
  const ReplayTimeline timeline = sampleReplay();
  const auto one = drawContactSheet(timeline, specOf(timeline, 800), {1.0}, {});
  const auto five = drawContactSheet(timeline, specOf(timeline, 800), {1, 2, 3, 4, 5}, {});
  REQUIRE(one);
  REQUIRE(five);
  CHECK(five->width() == 800);
  CHECK(one->height() > five->height());  // a single picture takes the whole width
  CHECK_FALSE(drawContactSheet(timeline, specOf(timeline, 200), {1, 2, 3, 4}, {}));
}

TEST_CASE("paths break where a play begins", "[unit]") {
  const ReplayTimeline timeline = sampleReplay();
  const auto paths = pathsBetween(timeline, 7.0, 12.0);
  CHECK(paths.size() == 10);
  for (const BodyTrail& path : paths) {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      CHECK(distance(path.points[i - 1], path.points[i]) < 0.05);
    }
  }
}

TEST_CASE("an SVG picture holds any name safely", "[unit]") {
  const ReplayTimeline timeline =
      sampleReplay({"<script>alert(\"1\")</script> & 'co'", "a\x01\xff\xef\xbf\xbe"});
  const auto svg = matchSvg(specOf(timeline), timeline.at(8.5));
  REQUIRE(svg);
  CHECK(svg->find("<script") == std::string::npos);
  CHECK(svg->find("&lt;script&gt;") != std::string::npos);
  CHECK(svg->find('\x01') == std::string::npos);
  CHECK(svg->find('\xff') == std::string::npos);
  CHECK(svg->starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(svg->ends_with("</svg>\n"));
  CHECK(svg->find("nan") == std::string::npos);
}

TEST_CASE("XML escapes keep good UTF-8 and nothing else", "[unit]") {
  CHECK(escapedXml("Caf\xc3\xa9 \xf0\x9f\xa4\x96") == "Caf\xc3\xa9 \xf0\x9f\xa4\x96");
  CHECK(escapedXml("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&#39;");
  CHECK(escapedXml("\xc0\xaf") == "  ");            // overlong encoding
  CHECK(escapedXml("\xed\xa0\x80") == "   ");       // half of a surrogate pair
  CHECK(escapedXml("\xf4\x90\x80\x80") == "    ");  // beyond the range of Unicode
  CHECK(escapedXml("x\xe2\x82") == "x  ");          // incomplete character
  CHECK(escapedXml("\xef\xbf\xbf|") == " |");
}

}  // namespace fulbito
