#include "tests/support/catch.hpp"
#include "tests/unit/tournament/report/samples.hpp"
#include "tournament/report/report.hpp"

using namespace fulbito;
using namespace fulbito::test;

TEST_CASE("the CSV has a line per match with the seats of its leg", "[unit]") {
  StateMaker maker(planOf(TournamentFormat::kRoundRobin, {"alpha", "be\"ta\nx"}));
  PairResult pair = pairOf({3, 1}, {0, 2}, 7);
  pair.legs[1].outcome = MatchOutcome::kCrash;
  pair.legs[1].faults.teams[1].failures = 1;
  maker.add({0, 1, 0, 0}, pair).add({0, 1, 1, 1}, std::nullopt);
  CHECK(tournamentCsv(maker.state()) ==
        "pair,leg,counts,round,id,blue,yellow,start,seed,goals_blue,goals_yellow,winner,outcome,fault_blue,"
        "fault_yellow,goals_after_foul_blue,goals_after_foul_yellow,simulated_s,abandoned,final_hash\n"
        "0,1,true,0,000000000000f00d0000000000000000,\"alpha\",\"be\"\"ta x\",kick-off:0,7,3,1,blue,normal,"
        "normal,normal,0,0,60,false,0000000000000aed\n"
        "0,2,true,0,000000000000f00d0000000000000001,\"be\"\"ta x\",\"alpha\",kick-off:0,7,2,0,blue,crash,"
        "normal,crash,0,0,60,false,0000000000000adc\n");
}
