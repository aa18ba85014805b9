#include <algorithm>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/sample_recording.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr const char* kWild =
    "a\xc2\x9b"
    "31mb\xe2\x80\xae"
    "c\x7f"
    "d\xe2\x80\xa8"
    "e\n\x1b[2Jf";

/// Whether text would steer a terminal, or make lines that the program did not mean.
bool isWild(const std::string& text) {
  for (const char* part : {"\xc2\x9b", "\xe2\x80\xae", "\x7f", "\xe2\x80\xa8", "\x1b"}) {
    if (contains(text, part)) return true;
  }
  return false;
}

std::size_t linesIn(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A recording in which every text is wild.
std::string wildRecording(const std::string& text) {
  Told told;
  told.header = sampleHeader();
  told.header.recipe.teams = {text, text};
  told.header.build.compiler = text;
  told.header.recipe.navigator = text;
  Teller teller(told);
  teller.tell(5, false);
  RecordedEvent event;
  event.tick = 5;
  event.clause = event.law = text;
  for (int i = 0; i < 3; ++i) teller.writer().add(event);
  REQUIRE(teller.finish(5));
  return told.bytes;
}

}  // namespace

TEST_CASE("texts of a recording steer no terminal and break no line", "[cli]") {
  const Sandbox box;
  box.write("wild.fbr", wildRecording(kWild));
  box.write("tame.fbr", wildRecording("name"));
  for (const std::string command : {"replay info", "replay events"}) {
    const Output wild = box.run(command + " wild.fbr"), tame = box.run(command + " tame.fbr");
    INFO(command << "\n" << wild.err);
    REQUIRE(wild.code == tame.code);
    CHECK_FALSE(wild.out.empty());
    CHECK_FALSE(isWild(wild.out + wild.err));
    CHECK(linesIn(wild.out) == linesIn(tame.out));
    const Output json = box.run(command + " wild.fbr --json");
    CHECK_FALSE(isWild(json.out));
    CHECK(linesIn(json.out) == linesIn(box.run(command + " tame.fbr --json").out));
  }
  const Json info = Json::parse(box.run("replay info wild.fbr --json").out);
  CHECK(info["recipe"]["teams"][0] == kWild);
}

TEST_CASE("names of a plan steer no report and are no formulas", "[cli]") {
  const Sandbox box;
  box.write("plan.toml",
            "[tournament]\nname = \"=HYPERLINK(1)\\u009b\\u202e\"\nformat = 'match'\npairs = 1\n"
            "[match]\nhalf_seconds = 1\n[[team]]\nteam = 'idle'\nname = \"@SUM(A1)\\u009b\\u2028x\"\n"
            "[[team]]\nteam = 'idle'\nname = \"-2+3\\u202e\"\n");
  const Output played =
      box.run("tournament run plan.toml --csv r.csv --html r.html --markdown r.txt --junit r.xml");
  INFO(played.err);
  REQUIRE(played.code == 0);
  CHECK_FALSE(isWild(played.out + played.err));
  CHECK_FALSE(isWild(box.run("tournament report fulbito-tournament --json").out));
  for (const char* file : {"r.csv", "r.html", "r.txt", "r.xml"}) {
    INFO(file);
    CHECK_FALSE(isWild(contentOf(box.path / file)));
  }
  const std::string csv = contentOf(box.path / "r.csv");
  CHECK(linesIn(csv) == 3);
  CHECK(contains(csv, ",\"'@SUM(A1)  x\",\"'-2+3 \","));
}
