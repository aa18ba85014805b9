#include "bridge/wire/referee_words.hpp"

#include "fulbito/referee.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::wire {

TEST_CASE("each restart has a foul of its own, and the foul names the restart", "[unit]") {
  for (const RestartKind kind : {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                 RestartKind::kPenalty, RestartKind::kGoalKick}) {
    CAPTURE(nameOf(kind));
    CHECK(isRestart(foulOf(kind)));
    CHECK(restartOf(foulOf(kind)) == kind);
  }
  CHECK(foulOf(RestartKind::kGiven) == Foul::kStop);
  for (const Foul foul : {Foul::kStop, Foul::kGameOn, Foul::kHalt}) CHECK_FALSE(isRestart(foul));
}

TEST_CASE("periods and parts of overtime are halves of the wire, and back", "[unit]") {
  for (const int period : {1, 2, kOvertimePeriod, kShootOutPeriod}) {
    CHECK(periodOf(halfOf(period, 1)) == period);
    CHECK(overtimePartOf(halfOf(period, 1)) == 1);
  }
  for (const int part : {2, 3}) {
    CHECK(halfOf(kOvertimePeriod, part) == Half::kOvertimeSecond);
    CHECK(overtimePartOf(halfOf(kOvertimePeriod, part)) == 2);
  }
  CHECK(periodOf(Half::kOvertimeSecond) == kOvertimePeriod);
  CHECK(periodOf(Half::kNone) == 1);
}

TEST_CASE("quadrants count from the first one, counter-clockwise", "[unit]") {
  CHECK(quadrantOf({0.1, 0.1}) == 1);
  CHECK(quadrantOf({-0.1, 0.1}) == 2);
  CHECK(quadrantOf({-0.1, -0.1}) == 3);
  CHECK(quadrantOf({0.1, -0.1}) == 4);
}

TEST_CASE("commands are the same whatever their times", "[unit]") {
  RefereeCommand command, later;
  later.seconds = 1.0;
  CHECK(sameCommand(command, later));
  later.quadrant = 2;
  CHECK_FALSE(sameCommand(command, later));
}

}  // namespace fulbito::wire
