#include "match/drills/trial_run.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// What a run of trials needs; the tested team is classic.
struct Coached {
  DrillOptions options;
  DrillRun run{options, *loadRobot("vsss"), *loadPhysics("standard")};

  Coached() { options.team = *parseTeam("classic"); }
};

}  // namespace

TEST_CASE("a trial gives the same by phases as by ticks, in any drill of trials", "[unit]") {
  const Coached coached;
  for (const Drill& drill : builtInDrills()) {
    if (drill.starts.empty()) continue;
    const auto base = drillMatch(coached.run, drill);
    for (int index = 0; index < 3; ++index) {
      auto trial = DrillTrialRun::create(coached.run, drill, *base, {1, index});
      REQUIRE(trial);
      while ((*trial)->advance()) CHECK_FALSE((*trial)->over());
      const auto verdict = (*trial)->result();
      const auto played = playTrial(coached.run, drill, *base, index);
      INFO("drill " << drill.number << " trial " << index);
      CHECK(verdict->success == played->success);
      CHECK(verdict->time == played->time);
      CHECK(verdict->error == played->error);
      CHECK(verdict->ideal == played->ideal);
      CHECK(verdict->stopped_by == played->stopped_by);
    }
  }
}

TEST_CASE("another team may stand in where a drill asks for the team itself", "[unit]") {
  Coached coached;
  coached.options.itself = *parseTeam("chaser");
  const Drill& drill = builtInDrills()[11];
  const auto base = drillMatch(coached.run, drill);
  const auto trial = DrillTrialRun::create(coached.run, drill, *base, {1, 1});
  REQUIRE(trial);
  const auto& teams = (*trial)->match().config().teams;
  CHECK(teams[indexOf((*trial)->scene().seat)].text == "classic");
  CHECK(teams[indexOf(other((*trial)->scene().seat))].text == "chaser");
}

}  // namespace fulbito
