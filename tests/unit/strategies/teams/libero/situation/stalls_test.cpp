#include "strategies/teams/libero/situation/stalls.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

constexpr double kOurs = -0.5, kTheirs = 0.5;  // [m] x of a ball
constexpr double kSoon = 0.6, kLong = 2.1;     // [s] a stall has begun; an opponent leans on

/// A ball with an opponent next to it.
struct Duel {
  Observation seen;
  libero::Pitch pitch;
  libero::BallForecast forecast;
  libero::Stalls stalls;

  explicit Duel(const char* robot = "vsss") : pitch(test::infoOf(3, robot)) {
    seen.playing = true;
    seen.team_size = 3;
    seen.dt = pitch.tick;
    seen.own[0] = seen.own[1] = test::standingAt({{-0.7, 0.0}, 0.0});
    seen.opponents[0] = test::standingAt({{0.7, 0.0}, 0.0});
  }

  void tick(double stuck) {
    forecast.take(seen.ball, {});
    stalls.watch({seen, pitch, forecast, stuck});
  }

  /// The ball lies at `x` for `seconds`. Returns whether libero gives the stall up.
  bool lies(double x, double seconds) {
    for (double passed = 0.0; passed < 5.0; passed += seen.dt) tick(0.0);  // what was before is over
    seen.ball.position = {x, 0.6};
    opponentAt({x + 0.06, 0.6});
    for (double stuck = seen.dt; stuck < seconds; stuck += seen.dt) tick(stuck);
    return stalls.isGivenUp();
  }

  void opponentAt(Vec2 place, Vec2 velocity = {}) {
    seen.opponents[1] = test::standingAt({place, 0.0});
    seen.opponents[1].state.velocity = velocity;
  }

  void opponentsGiveUpOne() {
    lies(kOurs, kSoon);
    opponentAt({kOurs + 0.3, 0.6}, {0.5, 0.0});
    tick(kSoon);
  }
};

}  // namespace

TEST_CASE(
    "libero gives up one stall, or two where robots cannot shove, and three for each that the "
    "opponents give up",
    "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    Duel duel(robot);
    CHECK_FALSE(duel.lies(kTheirs, 0.4));
    CHECK(duel.lies(kTheirs, kSoon));
    CHECK(duel.lies(kTheirs, kSoon) != duel.pitch.shoves);
    CHECK_FALSE(duel.lies(kTheirs, kSoon));
    duel.opponentsGiveUpOne();
    CHECK_FALSE(duel.stalls.isGivenUp());  // never in our half
    for (const bool given : {true, true, true, false}) CHECK(duel.lies(kTheirs, kSoon) == given);
    duel.stalls.forget();
    CHECK(duel.lies(kTheirs, kSoon));
  }
}

TEST_CASE("libero gives no stalls up to opponents that lean on in two more than they give up", "[unit]") {
  Duel duel;
  duel.lies(kOurs, kLong);
  duel.lies(kOurs, kLong);
  CHECK_FALSE(duel.lies(kTheirs, kSoon));
  duel.opponentsGiveUpOne();
  CHECK(duel.lies(kTheirs, kSoon));
}

TEST_CASE("an opponent that lets go of the ball for a moment does not give the stall up", "[unit]") {
  for (const Vec2 velocity : {Vec2{}, Vec2{-0.5, 0.0}}) {
    Duel duel;
    CHECK(duel.lies(kTheirs, kSoon));
    duel.lies(kOurs, kSoon);
    duel.opponentAt({kOurs + 0.3, 0.6}, velocity);
    duel.tick(kSoon);
    CHECK_FALSE(duel.lies(kTheirs, kSoon));
  }
}

TEST_CASE("libero's first offers are far from its goal", "[unit]") {
  Duel duel;
  CHECK_FALSE(duel.lies(0.3, kSoon));
  CHECK(duel.lies(kTheirs, kSoon));
  duel.opponentsGiveUpOne();
  CHECK(duel.lies(0.3, kSoon));
  duel.lies(kOurs, kLong);  // they lean on once, too
  CHECK(duel.lies(0.3, kSoon));
}

TEST_CASE("robots that shove leave a stall sooner, once the opponents are known to withdraw", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    Duel duel(robot);
    const double jams = duel.pitch.tuning.jam_time + 0.05;
    CHECK_FALSE(duel.lies(kTheirs, jams));
    duel.opponentsGiveUpOne();
    CHECK(duel.lies(kTheirs, jams) == duel.pitch.shoves);
  }
}

TEST_CASE("libero gives no disputed free ball up", "[unit]") {
  Duel duel;
  duel.seen.restart = RestartKind::kFreeBall;
  duel.seen.since_restart = 1.0;
  CHECK_FALSE(duel.lies(kTheirs, kSoon));
  duel.seen.since_restart = duel.pitch.tuning.patience + 1.0;
  CHECK(duel.lies(kTheirs, kSoon));
}

TEST_CASE("a withdrawal ends with the play, near our goal, and once no opponent is near the ball", "[unit]") {
  Duel duel;
  duel.opponentsGiveUpOne();
  REQUIRE(duel.lies(kTheirs, kSoon));
  duel.seen.ball.position.x = -0.55 * duel.pitch.half_length;
  duel.opponentAt(duel.seen.ball.position + Vec2{0.1, 0.0});
  duel.tick(0.0);
  CHECK_FALSE(duel.stalls.isGivenUp());
  duel.stalls.forget();
  REQUIRE(duel.lies(kTheirs, kSoon));
  duel.opponentAt({-0.7, 0.6});
  duel.tick(kSoon);
  CHECK_FALSE(duel.stalls.isGivenUp());
  duel.stalls.forget();
  REQUIRE(duel.lies(kTheirs, kSoon));
  duel.seen.playing = false;
  duel.tick(0.0);
  CHECK_FALSE(duel.stalls.isGivenUp());
}

TEST_CASE("a withdrawal ends once the ball has left, but for robots that shove and give stalls up",
          "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    Duel duel(robot);
    const auto leaves = [&] {
      REQUIRE(duel.lies(kTheirs, kSoon));
      duel.seen.ball.position.x -= 0.9 * duel.pitch.tuning.behind;
      duel.tick(0.0);
      CHECK(duel.stalls.isGivenUp());
      duel.seen.ball.position.x -= 0.2 * duel.pitch.tuning.behind;
      duel.opponentAt(duel.seen.ball.position + Vec2{0.1, 0.0});
      duel.tick(0.0);
      return !duel.stalls.isGivenUp();
    };
    CHECK(leaves());
    duel.opponentsGiveUpOne();
    CHECK(leaves() != duel.pitch.shoves);
  }
}

}  // namespace fulbito
