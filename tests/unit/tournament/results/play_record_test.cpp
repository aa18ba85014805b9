#include "tournament/results/play_record.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("a record keeps the statistics of a match", "[unit]") {
  MatchStatistics statistics;
  statistics.play_ticks = 100;
  statistics.wall_ticks = 20;
  statistics.corner_ticks = 10;
  statistics.teams[1].shots = 5;
  statistics.teams[1].shots_on_goal = 3;
  statistics.teams[1].own_goals = 1;
  statistics.teams[1].thirds = {40, 50, 10};
  statistics.teams[1].play.locks = 2;
  const PlayRecord record = recordOf(statistics);
  CHECK(record.play_ticks == 100);
  CHECK(record.wall_ticks == 20);
  CHECK(record.corner_ticks == 10);
  const TeamRecord& yellow = record.teams[1];
  CHECK(yellow.shots == 5);
  CHECK(yellow.shots_on_goal == 3);
  CHECK(yellow.own_goals == 1);
  CHECK(yellow.own_third == 40);
  CHECK(yellow.locks == 2);
}

TEST_CASE("records add up by team, not by colour, and keep the longest contact", "[unit]") {
  PlayRecord one, two, sum;
  one.play_ticks = two.play_ticks = 60;
  one.teams[0].longest_contact = 7;
  two.teams[1].longest_contact = 9;
  for (const auto count : kPlayCounts) {
    if (count == &TeamRecord::longest_contact) continue;
    one.teams[0].*count = 1;
    two.teams[1].*count = 2;
    one.teams[1].*count = 10;
  }
  sum.add(one, 0);
  sum.add(two, 1);
  CHECK(sum.play_ticks == 120);
  CHECK(sum.teams[0].longest_contact == 9);
  for (const auto count : kPlayCounts) {
    if (count == &TeamRecord::longest_contact) continue;
    CHECK(sum.teams[0].*count == 3);
    CHECK(sum.teams[1].*count == 10);
  }
}

}  // namespace fulbito
