#include "replays/export/tables.hpp"

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/sample_replay.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::json;

std::vector<std::string> linesOf(void (*write)(const ReplayTimeline&, double, double, const TableSink&),
                                 double from, double to) {
  std::string text;
  write(test::sampleReplay({"a\"b", "\xff"}), from, to, [&](const std::string& piece) { text += piece; });
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a CSV has a line for each sample, of as many columns as its head", "[unit]") {
  const auto lines = linesOf(writeCsv, 0.0, 20.0);
  CHECK(lines.size() == 1 + 601);  // samples at 30 Hz and the start
  CHECK(lines[0].starts_with("tick,time_s,play,period,play_s,playing,score_blue,score_yellow,blue0_x"));
  CHECK(lines[0].ends_with("ball_x,ball_y"));
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  for (const std::string& line : lines) REQUIRE(commas(line) == commas(lines[0]));
  CHECK(lines[1].starts_with("0,0.0000,1,1,0.0000,1,0,0,0.2000,0.0000,"));
  CHECK(linesOf(writeCsv, 5.0, 6.0).size() == 1 + 31);
}

TEST_CASE("JSON lines tell plays, events and states in the order of time", "[unit]") {
  const auto lines = linesOf(writeJsonLines, 7.0, 16.0);
  const Json head = Json::parse(lines[0]);
  CHECK(head["schema_version"] == 1);
  CHECK(head["bodies"].size() == 5);
  int plays = 0, events = 0;
  Tick last = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Json json = Json::parse(lines[i]);
    REQUIRE(json["tick"].get<Tick>() >= last);
    last = json["tick"];
    plays += json["type"] == "play" ? 1 : 0;
    events += json["type"] == "event" ? 1 : 0;
    if (json["type"] == "state") REQUIRE(json["bodies"]["ball"].size() == 2);
  }
  CHECK(plays == 2);
  CHECK(events == 2);
}

}  // namespace fulbito
