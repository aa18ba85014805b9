#include "replays/render/canvas/text_fit.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

Canvas canvas() { return *Canvas::create(10, 10, {}); }

}  // namespace

TEST_CASE("a text that fits stays as it is", "[unit]") {
  const Canvas paper = canvas();
  CHECK(fitted(paper, "bezier", 14, 200) == "bezier");
  CHECK(fitted(paper, "", 14, 200).empty());
}

TEST_CASE("a text that is too long ends in an ellipsis and fits", "[unit]") {
  const Canvas paper = canvas();
  const std::string cut = fitted(paper, "a name without an end in sight", 14, 80);
  CHECK(cut.size() > 5);
  CHECK(cut.substr(cut.size() - 3) == "\u2026");
  CHECK(paper.textWidth(cut, 14) <= 80);
  CHECK(paper.textWidth(cut, 14) > 60);
}

TEST_CASE("a cut never splits a character", "[unit]") {
  const Canvas paper = canvas();
  std::string accents;
  for (int i = 0; i < 40; ++i) accents += "\u00e9";
  for (double width = 30; width < 120; width += 3) {
    const std::string cut = fitted(paper, accents, 14, width);
    CAPTURE(width);
    REQUIRE(cut.size() >= 3);
    CHECK((cut.size() - 3) % 2 == 0);
  }
}

TEST_CASE("nothing remains where not even an ellipsis fits", "[unit]") {
  CHECK(fitted(canvas(), "word", 14, 3).empty());
}

TEST_CASE("a text of a megabyte is cut quickly", "[unit]") {
  const Canvas paper = canvas();
  const std::string cut = fitted(paper, std::string(1'000'000, 'm'), 14, 300);
  CHECK(cut.size() < 60);
  CHECK(paper.textWidth(cut, 14) <= 300);
}

}  // namespace fulbito
