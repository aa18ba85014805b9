#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/markup.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

std::string annotationsOf(const TournamentState& state) {
  return tournamentAnnotations(state, tableOf(state));
}

void fault(TournamentState& state, std::size_t fixture, MatchOutcome outcome) {
  MatchResult& result = state.results[fixture]->legs[0];
  TeamFaults& faults = result.faults.teams[0];
  result.outcome = outcome;
  faults.forfeited = outcome == MatchOutcome::kForfeit;
  faults.failures = outcome == MatchOutcome::kForfeit || outcome == MatchOutcome::kCrash ? 1 : 0;
  faults.failure = faults.failures > 0 ? "exit 1,\n100 %" : "";
  faults.late = outcome == MatchOutcome::kSlow ? 3 : 0;
}

}  // namespace

TEST_CASE("a tournament without faults has no annotation", "[unit]") {
  CHECK(annotationsOf(madeUpRoundRobin({"a", "b"}).state()).empty());
}

TEST_CASE("annotations come worst first, with their special characters escaped", "[unit]") {
  StateMaker maker = madeUpRoundRobin({"sl:ow", "cra,sh", "gone%"});  // fixtures 0-1, 0-2, 1-2
  maker.add({2, 0, 0, 0}, pairOf({0, 0}, {0, 0}));
  fault(maker.state(), 0, MatchOutcome::kSlow);
  fault(maker.state(), 2, MatchOutcome::kCrash);
  fault(maker.state(), 3, MatchOutcome::kForfeit);
  CHECK(annotationsOf(maker.state()) ==
        "::error title=gone%25 forfeited 1 match::last: exit 1, 100 %25\n"
        "::error title=cra%2Csh crashed in 1 match::last: exit 1, 100 %25\n"
        "::warning title=sl%3Aow was late in 1 match::of 6 matches\n");
}

TEST_CASE("a test that fails is the first error, with its figures as lines of one annotation", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 40));
  for (std::size_t i = 0; i < 40; ++i) maker.add({0, 1, 0, i}, pairOf({0, 3}, {0, 1}));
  fault(maker.state(), 0, MatchOutcome::kCrash);
  maker.test({-50, 0, 0.05, 0.05});
  const std::string text = annotationsOf(maker.state());
  CHECK(
      text.starts_with("::error title=alpha against beta%3A fail%2C rather -50 than +0 normalized Elo::"
                       "log-likelihood ratio: -"));
  CHECK(text.find("%0Apairs: ") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 2);
}

TEST_CASE("a test without a verdict is a warning once it is over", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kMatch, {"alpha", "beta"}, 1));
  maker.add({0, 1, 0, 0}, pairOf({1, 0}, {0, 1})).test({-50, 0, 0.05, 0.05});
  CHECK(annotationsOf(maker.state()).starts_with("::warning title=alpha against beta%3A inconclusive"));
  maker.add({0, 1, 0, 1}, std::nullopt);
  CHECK(annotationsOf(maker.state()).empty());
}

TEST_CASE("at most 10 annotations, the last one counts the rest", "[unit]") {
  const auto crashed = [](std::size_t teams) {
    StateMaker maker = madeUpRoundRobin(teamNames(teams));
    for (auto& pair : maker.state().results) {
      for (TeamFaults& faults : pair->legs[0].faults.teams) faults.failures = 1;
    }
    return annotationsOf(maker.state());
  };
  const std::string ten = crashed(10);
  CHECK(std::count(ten.begin(), ten.end(), '\n') == 10);
  CHECK(ten.find("more findings") == std::string::npos);
  const std::string many = crashed(30);
  CHECK(std::count(many.begin(), many.end(), '\n') == 10);
  CHECK(many.find("\n::error title=21 more findings::") != std::string::npos);
}

TEST_CASE("hostile names cannot start a command of their own", "[unit]") {
  StateMaker maker = madeUpRoundRobin(hostileNames());
  for (std::size_t i = 0; i < maker.state().results.size(); ++i)
    fault(maker.state(), i, MatchOutcome::kCrash);
  const std::string text = annotationsOf(maker.state());
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1, ++lines) {
    CHECK(text.compare(at, 13, "::error title") == 0);
  }
  CHECK(lines <= 10);
  CHECK(text.find('\r') == std::string::npos);
  CHECK(text.size() < 8192);
}
