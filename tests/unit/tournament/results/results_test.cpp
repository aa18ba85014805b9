#include "tournament/results/results.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("names of outcomes read back", "[unit]") {
  for (const MatchOutcome outcome : {MatchOutcome::kNormal, MatchOutcome::kMercy, MatchOutcome::kSlow,
                                     MatchOutcome::kIllegal, MatchOutcome::kCrash, MatchOutcome::kForfeit}) {
    CHECK(outcomeOf(nameOf(outcome)) == outcome);
  }
  CHECK_FALSE(outcomeOf("lost"));
}

TEST_CASE("an identity as text reads back, and nothing else does", "[unit]") {
  const MatchId id{{0x0123456789abcdefULL, 7}};
  CHECK(id.text() == "0123456789abcdef0000000000000007");
  CHECK(MatchId::parse(id.text()) == id);
  for (const char* text : {"", "0123456789abcdef000000000000000", "0123456789ABCDEF0000000000000007",
                           "0123456789abcdef00000000000000007", "0123456789abcdef000000000000000g",
                           "+123456789abcdef0000000000000007"}) {
    CHECK_FALSE(MatchId::parse(text));
  }
}

TEST_CASE("points follow the winner, who may be decided by kicks", "[unit]") {
  PairResult pair;
  CHECK(pair.points() == 0.5);
  pair.legs[0].score = {2, 1};
  pair.legs[0].winner = TeamId::kBlue;
  CHECK(pair.points() == 0.75);
  pair.legs[1].score = {1, 1};
  pair.legs[1].winner = TeamId::kYellow;  // A plays yellow
  CHECK(pair.points() == 1.0);
  CHECK(pair.goalsOfA() == 3);
  CHECK(pair.goalsOfB() == 2);
}

}  // namespace fulbito
