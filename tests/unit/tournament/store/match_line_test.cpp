#include "tournament/store/match_line.hpp"

#include <limits>

#include "fulbito/detail/state_hash.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"

namespace fulbito::test {
namespace {

/// A line with the correct checksum of `body`, which is JSON without its last brace.
std::string signedLine(const std::string& body) {
  StateHash hash;
  hash.add(std::string_view(body));
  return fmt::format("{},\"sum\":\"{:016x}\"}}", body, hash.value());
}

/// The line of match 1 with a part of its text replaced, and the correct checksum of the new text.
std::string changedLine(const std::string& part, const std::string& by) {
  std::string body = toLine(matchRow(1));
  body.resize(body.rfind(",\"sum\""));
  const auto at = body.find(part);
  REQUIRE(at != std::string::npos);
  return signedLine(body.replace(at, part.size(), by));
}

std::string errorOf(const std::string& line) {
  const auto row = parseLine(line);
  return row ? "no error" : row.error().message;
}

/// A row in which every value is extreme or unusual.
MatchRow unusualRow() {
  MatchRow row = matchRow(0xfedcba9876543210u);
  row.seed = std::numeric_limits<std::uint64_t>::max();
  row.result.hash = 1;  // has leading zeros
  row.result.ticks = std::numeric_limits<Tick>::max();
  row.result.play.wall_ticks = std::numeric_limits<Tick>::max();
  std::int64_t next = 1;
  for (const auto count : kPlayCounts) row.result.play.teams[1].*count = next++;
  row.result.score = {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  row.result.outcome = MatchOutcome::kForfeit;
  row.result.winner.reset();
  TeamFaults& faults = row.result.faults.teams[1];
  faults = {1, 2, 3, 4, 5, std::numeric_limits<std::int64_t>::max(), "line\n\"end\" \\ \x01 \u00e9", true};
  row.result.faults.abandoned = Error{ErrorCode::kBadInput, "robots overlap"};
  row.teams = {"", "a \"quoted\" name"};
  return row;
}

}  // namespace

TEST_CASE("a line has the keys in a fixed order and a checksum", "[unit]") {
  MatchRow row;
  row.id.words = {0x0123456789abcdefu, 0x1u};
  row.teams = {"classic", "libero"};
  row.start = "kick-off";
  row.seed = 18446744073709551615u;
  row.result.score = {1, 0};
  row.result.winner = TeamId::kBlue;
  row.result.play = {30000, 9000, 300, {}};
  row.result.play.teams[1].shots = 4;
  row.result.play.teams[1].locks = 1;
  row.result.ticks = 36000;
  row.result.hash = 0xabcu;
  row.result.faults.teams[0].late = 3;
  CHECK(toLine(row) ==
        signedLine("{\"id\":\"0123456789abcdef0000000000000001\",\"teams\":[\"classic\",\"libero\"],"
                   "\"start\":\"kick-off\",\"seed\":18446744073709551615,\"score\":[1,0],"
                   "\"winner\":\"blue\",\"goals_after_foul\":[0,0],\"play_ticks\":30000,\"wall_ticks\":9000,"
                   "\"corner_ticks\":300,\"play\":[[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0],[4,0,0,0,0,0,0,0,0,0,0,0,"
                   "1,0,0]],\"ticks\":36000,"
                   "\"final_hash\":\"0000000000000abc\",\"outcome\":\"normal\","
                   "\"faults\":[{\"late\":3},{}]") +
            "\n");
}

TEST_CASE("every value of a row comes back from its line", "[unit]") {
  const MatchRow row = unusualRow();
  const auto back = parseLine(toLine(row));
  REQUIRE(back);
  CHECK(back->id == row.id);
  CHECK(back->teams == row.teams);
  CHECK(back->start == row.start);
  CHECK(back->seed == row.seed);
  CHECK(sameResult(back->result, row.result));
  CHECK(back->result.faults.teams[1].failure == row.result.faults.teams[1].failure);
  CHECK(back->result.faults.abandoned->message == "robots overlap");
  CHECK(toLine(*back) == toLine(row));
}

TEST_CASE("a thousand rows come back from their lines", "[unit]") {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto back = parseLine(toLine(matchRow(i)));
    REQUIRE(back);
    REQUIRE(toLine(*back) == toLine(matchRow(i)));
    REQUIRE(sameResult(back->result, matchRow(i).result));
  }
}

TEST_CASE("untrusted text is stored as UTF-8 of limited length", "[unit]") {
  MatchRow row = matchRow(1);
  row.result.faults.teams[0].failure = std::string("bad \xff\xfe\xc3(byte\x00s)", 15);
  row.result.faults.teams[1].failure = std::string(1 << 20, '\xff');
  const MatchRow stored = storedForm(row);
  CHECK(stored.result.faults.teams[0].failure == std::string("bad \uFFFD\uFFFD\uFFFD(byte\0s)", 21));
  CHECK(stored.result.faults.teams[1].failure.size() <= kLongestRowText);
  CHECK(stored.result.faults.teams[1].failure.find("bytes omitted") != std::string::npos);
  CHECK(toLine(row) == toLine(stored));
  CHECK(toLine(storedForm(stored)) == toLine(stored));
  CHECK(parseLine(toLine(row))->result.faults.teams[0].failure == stored.result.faults.teams[0].failure);
}

TEST_CASE("the longest row fits into the longest line", "[unit]") {
  MatchRow row = unusualRow();
  const std::string longest(kLongestRowText, '\x01');  // each byte takes six bytes in JSON
  row.teams = {longest, longest};
  row.start = longest;
  for (TeamFaults& team : row.result.faults.teams) team.failure = longest;
  row.result.faults.abandoned->message = longest;
  CHECK(toLine(row).size() > 6 * 6 * kLongestRowText);
  CHECK(toLine(row).size() < kLongestLine);
  CHECK(parseLine(toLine(row)));
}

TEST_CASE("any changed byte of a line is noticed", "[unit]") {
  const std::string line = toLine(matchRow(5));
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    std::string changed = line;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    CHECK_FALSE(parseLine(changed));
  }
  for (std::size_t size = 0; size + 1 < line.size(); ++size) CHECK_FALSE(parseLine(line.substr(0, size)));
  CHECK(errorOf(line.substr(1)) == "the line is damaged: its checksum differs");
}

TEST_CASE("a line of another shape is refused, though its checksum is right", "[unit]") {
  CHECK(errorOf(changedLine("\"seed\"", "\"sead\"")) == "not a match: 'seed' is missing or wrong");
  CHECK(errorOf(changedLine("\"seed\":", "\"seed\":-")) == "not a match: 'seed' is missing or wrong");
  CHECK(errorOf(changedLine("\"seed\":1", "\"seed\":99991")) == "not a match: 'seed' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":[1,1,1]")) ==
        "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":[1]")) ==
        "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":1")) == "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":[1,2147483648]")) ==
        "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":[1,1.0]")) ==
        "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"score\":[1,1]", "\"score\":[[1,1]]")) ==
        "not a match: 'score' is missing or wrong");
  CHECK(errorOf(changedLine("\"winner\":\"yellow\"", "\"winner\":\"red\"")) ==
        "not a match: 'winner' is missing or wrong");
  CHECK(errorOf(changedLine("\"ticks\":18001", "\"ticks\":null")) ==
        "not a match: 'ticks' is missing or wrong");
  CHECK(errorOf(changedLine("\"mercy\"", "\"merci\"")) == "not a match: 'outcome' is missing or wrong");
  CHECK(errorOf(changedLine("\"teams\":[\"classic\",\"libero\"]", "\"teams\":{}")) ==
        "not a match: 'teams' is missing or wrong");
  const std::string line = toLine(matchRow(1)), begin = "\"play\":";
  const std::size_t from = line.find(begin) + begin.size();
  const std::string written = line.substr(from, line.find("]]", from) + 2 - from);
  const std::string team = written.substr(1, written.find(']'));
  const std::string fewer = "[1,2,3,4,5,6,7,8,9,10,11,12,13,14]";
  for (const std::string& play :
       {"[" + team + "]", "[" + team + "," + team + "," + team + "]", std::string("{}"), std::string("[1,2]"),
        "[" + team + ",{}]", "[" + team + "," + fewer + "]", "[" + team + ",[[1]]]",
        "[" + team + ",[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16]]",
        "[" + team + ",[-1,2,3,4,5,6,7,8,9,10,11,12,13,14,15]]",
        "[" + team + ",[\"1\",2,3,4,5,6,7,8,9,10,11,12,13,14,15]]",
        "[" + team + ",[1.5,2,3,4,5,6,7,8,9,10,11,12,13,14,15]]"}) {
    CHECK(errorOf(changedLine(written, play)) == "not a match: 'play' is missing or wrong");
  }
  for (const char* faults :
       {"[{}]", "[{},{},{}]", "{}", "[[],[]]", "[1,2]", "[{\"late\":\"3\"},{}]", "[{\"late\":-1},{}]",
        "[{\"later\":1},{}]", "[{\"late\":1,\"late\":2},{}]", "[{\"failure\":1},{}]",
        "[{\"forfeited\":false},{}]", "[{\"forfeited\":1},{}]", "[{\"late\":{}},{}]"}) {
    CHECK(errorOf(changedLine("[{\"saturated\":1},{\"saturated\":1}]", faults)) ==
          "not a match: 'faults' is missing or wrong");
  }
  CHECK(errorOf(signedLine("{\"id\":\"0\"")) == "not a match: 'id' is missing or wrong");
  CHECK(errorOf(signedLine("[")) == "not a match: 'id' is missing or wrong");
  CHECK(errorOf(signedLine("{\"a\":1")) == "not a match: 'id' is missing or wrong");
}

TEST_CASE("results differ by each value but not by the words of a failure", "[unit]") {
  const MatchResult base = unusualRow().result;
  MatchResult same = base;
  same.faults.teams[1].failure = "process 4711 was killed";
  CHECK(sameResult(base, same));
  std::vector<MatchResult> others(16, base);
  others[0].score[1] = 5;
  others[1].winner = TeamId::kBlue;
  others[2].goals_after_foul[0] += 1;
  others[3].ticks -= 1;
  others[4].hash += 1;
  others[5].outcome = MatchOutcome::kCrash;
  others[6].faults.teams[0].forfeited = true;
  others[7].faults.teams[0].late += 1;
  others[8].faults.teams[1].not_finite += 1;
  others[9].faults.teams[1].no_navigator += 1;
  others[10].faults.teams[1].saturated += 1;
  others[11].faults.teams[1].stale += 1;
  others[12].faults.teams[1].failures -= 1;
  others[13].faults.abandoned.reset();
  others[14].play.corner_ticks += 1;
  others[15].play.teams[1].uncovered += 1;
  for (std::size_t i = 0; i < others.size(); ++i) {
    INFO(i);
    CHECK_FALSE(sameResult(base, others[i]));
  }
}

}  // namespace fulbito::test
