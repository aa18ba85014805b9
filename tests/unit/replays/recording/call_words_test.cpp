#include "replays/recording/call_words.hpp"

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

const std::vector<std::string> kNames{"libero", "classic"};

RecordedEvent callOf(const std::string& clause, std::optional<TeamId> team) {
  RecordedEvent event;
  event.clause = clause;
  event.team = team;
  return event;
}

/// Names of the rules that the referee calls, read from the header that lists them.
std::set<std::string> clausesOfTheReferee() {
  std::ifstream file(FULBITO_CLAUSES);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  static const std::regex quoted("string_view k[A-Za-z]+ = \"([^\"]+)\"");
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), quoted), end; match != end; ++match) {
    names.insert((*match)[1]);
  }
  return names;
}

}  // namespace

TEST_CASE("every rule that the referee calls has words", "[unit]") {
  const std::set<std::string> clauses = clausesOfTheReferee();
  REQUIRE(clauses.size() >= 11);
  for (const std::string& clause : clauses) {
    INFO(clause);
    CHECK_FALSE(wordsOf(callOf(clause, TeamId::kBlue), kNames).title.empty());
  }
}

TEST_CASE("a call has the colour of the team that gains by it", "[unit]") {
  const auto favours = [](const std::string& clause, TeamId team) {
    return wordsOf(callOf(clause, team), kNames).favours;
  };
  for (const TeamId team : kTeams) {
    CHECK(favours("goal", team) == team);
    CHECK(favours("kick-off", team) == team);
    CHECK(favours("full-time", team) == team);
    CHECK(favours("mercy", team) == team);
    CHECK(favours("shoot-out", team) == team);
    CHECK(favours("walk-over", team) == other(team));
    CHECK(favours("free-ball", team) == std::nullopt);
    CHECK(favours("false-start", team) == std::nullopt);
    CHECK(favours("placement", team) == std::nullopt);
    CHECK(favours("command.late", team) == std::nullopt);
  }
  // The event of a foul names the team at fault, so the other team has the ball.
  for (const std::string& clause : clausesOfTheReferee()) {
    if (clause.find('.') == std::string::npos) continue;
    INFO(clause);
    CHECK(favours(clause, TeamId::kYellow) == TeamId::kBlue);
    CHECK(favours(clause, TeamId::kBlue) == TeamId::kYellow);
  }
  CHECK(wordsOf(callOf("penalty.stuck", std::nullopt), kNames).favours == std::nullopt);
}

TEST_CASE("details name teams where the call does not say who", "[unit]") {
  const auto detail = [](const std::string& clause, std::optional<TeamId> team, double value = 0.0) {
    RecordedEvent event = callOf(clause, team);
    event.value = value;
    return wordsOf(event, kNames).detail;
  };
  CHECK(detail("goal", TeamId::kBlue) == "libero");
  CHECK(detail("goal-kick.keeper-charged", TeamId::kBlue) == "keeper charged");
  CHECK(detail("false-start", TeamId::kYellow) == "classic moved before the signal");
  CHECK(detail("full-time", std::nullopt) == "draw");
  CHECK(detail("full-time", TeamId::kYellow) == "classic wins");
  CHECK(detail("shoot-out", TeamId::kBlue, 1.0) == "libero scores");
  CHECK(detail("shoot-out", TeamId::kBlue) == "libero misses");
  CHECK(wordsOf(callOf("goal", TeamId::kYellow), {}).detail == "yellow");
  CHECK(wordsOf(callOf("command.late", TeamId::kYellow), kNames).title.empty());
}

TEST_CASE("restarts have the colour of the team that takes them, free balls none", "[unit]") {
  const CallWords kick = wordsOf(RestartKind::kGoalKick, TeamId::kYellow, kNames);
  CHECK(kick.title == "Goal kick");
  CHECK(kick.detail == "classic");
  CHECK(kick.favours == TeamId::kYellow);
  CHECK(wordsOf(RestartKind::kFreeBall, TeamId::kYellow, kNames).title == "Free ball");
  CHECK(wordsOf(RestartKind::kFreeBall, TeamId::kYellow, kNames).favours == std::nullopt);
  CHECK(wordsOf(RestartKind::kGiven, TeamId::kBlue, kNames).title.empty());
}

TEST_CASE("what was measured has its unit", "[unit]") {
  const auto text = [](const char* clause, double value, double threshold) {
    RecordedEvent event = callOf(clause, TeamId::kBlue);
    event.value = value;
    event.threshold = threshold;
    return measuredText(event);
  };
  CHECK(text("goal-kick.keeper-charged", 0.1234, 0.02) == "pressed with 0.123 N s (limit 0.02 N s)");
  CHECK(text("goal-kick.attackers", 2, 1) == "robots inside: 2 (limit 1)");
  CHECK(text("free-ball", 10.0, 10.0) == "for 10 s (limit 10 s)");
  CHECK(text("goal", 0.0223, 0.0215) == "ball past the line by 22.3 mm (limit 21.5 mm)");
  CHECK(text("placement", 0.035, 0.0) == "moved by 35 mm");
  CHECK(text("command.late", 10.0, 0.0) == "count 10");
  CHECK(text("vision.lost", 3.0, 0.0) == "frames 3");
  CHECK(text("referee.free-ball", 2.0, 0.0) == "quadrant 2");
  CHECK(text("half", 0.0, 0.0).empty());
  CHECK(text("shoot-out", 1.0, 0.0).empty());
}

}  // namespace fulbito
