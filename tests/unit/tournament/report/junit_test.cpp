#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/markup.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

std::string junitOf(const TournamentState& state, const RecordingLinks& recordings = {}) {
  return tournamentJunit(state, tableOf(state), recordings);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("JUnit has a suite per pairing and a case per match", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}));
  maker.add({0, 1, 0, 0}, pairOf({3, 1}, {0, 2}, 7));
  CHECK(junitOf(maker.state(), {{idOfNumber(0, 1).text(), "recordings/a&b.fbr"}}) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites name=\"cup\">\n"
        "  <testsuite name=\"cup\" tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"0\">\n"
        "    <testcase classname=\"cup\" name=\"finished\"></testcase>\n"
        "  </testsuite>\n"
        "  <testsuite name=\"alpha against beta\" tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"0\">\n"
        "    <testcase classname=\"alpha against beta\" name=\"1.1 kick-off:0 (blue alpha, yellow beta)\">"
        "<system-out>score 3:1, normal\nseed 7\nid 000000000000f00d0000000000000000\n"
        "hash 0000000000000aed</system-out></testcase>\n"
        "    <testcase classname=\"alpha against beta\" name=\"1.2 kick-off:0 (blue beta, yellow alpha)\">"
        "<system-out>score 2:0, normal\nseed 7\nid 000000000000f00d0000000000000001\n"
        "hash 0000000000000adc\nrecording recordings/a&amp;b.fbr</system-out></testcase>\n"
        "  </testsuite>\n"
        "</testsuites>\n");
}

TEST_CASE("both directions of a pairing share a suite", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kRoundRobin, {"a", "b"}));
  maker.add({0, 1, 0, 0}, pairOf({0, 0}, {0, 0})).add({1, 0, 1, 1}, pairOf({0, 0}, {0, 0}));
  CHECK(count(junitOf(maker.state()), "<testsuite ") == 2);
}

TEST_CASE("crashes and walk-overs are errors of JUnit, a failed test is a failure", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 40));
  for (std::size_t i = 0; i < 40; ++i) maker.add({0, 1, 0, i}, pairOf({0, 3}, {0, 1}));
  MatchResult& crash = maker.state().results[0]->legs[1];
  crash.outcome = MatchOutcome::kCrash;
  crash.faults.teams[0].failures = 1;
  crash.faults.teams[0].failure = "exit 1\x1b[0m <oops>";
  maker.test({-50, 0, 0.05, 0.05});
  const std::string xml = junitOf(maker.state());
  CHECK(xml.find("<error type=\"crash\" message=\"beta: exit 1 [0m &lt;oops&gt;\"/>") != std::string::npos);
  CHECK(count(xml, "<error ") == 1);
  CHECK(xml.find("errors=\"1\"") != std::string::npos);
  CHECK(xml.find("name=\"sequential test\"><failure message=\"rather -50 than +0 normalized Elo\"/>") !=
        std::string::npos);
  CHECK(xml.find("tests=\"2\" failures=\"1\"") != std::string::npos);
}

TEST_CASE("what is not known yet is skipped in JUnit, it does not pass", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 2));
  maker.add({0, 1, 0, 0}, pairOf({1, 0}, {0, 1})).add({0, 1, 0, 1}, std::nullopt);
  maker.test({-50, 0, 0.05, 0.05});
  const std::string xml = junitOf(maker.state());
  CHECK(count(xml, "<skipped ") == 2);
  CHECK(xml.find("tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"2\"") != std::string::npos);
}

TEST_CASE("hostile names leave JUnit well-formed", "[unit]") {
  StateMaker maker = madeUpRoundRobin(hostileNames());
  for (auto& pair : maker.state().results) {
    pair->legs[0].faults.teams[0].failures = 1;
    pair->legs[0].faults.teams[0].failure = "]]></error>\x01\xff\"'";
    pair->legs[0].outcome = MatchOutcome::kCrash;
  }
  maker.state().plan.name = "<\"&'\x02";
  const std::string xml = junitOf(maker.state());
  INFO(xml.substr(0, 3000));
  CHECK(flawOfMarkup(xml).empty());
}
