#include "replays/render/canvas/text_wrap.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace

TEST_CASE("a long name takes more lines and loses nothing", "[unit]") {
  const Canvas paper = *Canvas::create(10, 10, {});
  const std::string name = "tangent-field:offset=0.0784,range=5.56,hysteresis=0.239";
  const auto lines = wrapped(paper, name, 14, 200);
  CHECK(lines.size() > 1);
  CHECK(joined(lines) == name);
  for (const std::string& line : lines) CHECK(paper.textWidth(line, 14) <= 200);
  CHECK(wrapped(paper, "bezier", 14, 200) == std::vector<std::string>{"bezier"});
  CHECK(wrapped(paper, "", 14, 200) == std::vector<std::string>{""});
}

TEST_CASE("a sentence is broken between words", "[unit]") {
  const Canvas paper = *Canvas::create(10, 10, {});
  for (const std::string& line :
       wrapped(paper, "the robot turns by itself and then goes on its way", 14, 120)) {
    CHECK(line.front() != ' ');
    CHECK(line.back() != ' ');
    CHECK(paper.textWidth(line, 14) <= 120);
  }
}

TEST_CASE("a word wider than a line is broken inside, never within a character", "[unit]") {
  const Canvas paper = *Canvas::create(10, 10, {});
  std::string accents;
  for (int i = 0; i < 60; ++i) accents += "\u00e9";
  const auto lines = wrapped(paper, accents, 14, 100);
  CHECK(joined(lines) == accents);
  for (const std::string& line : lines) CHECK(line.size() % 2 == 0);
}

}  // namespace fulbito
