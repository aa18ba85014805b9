#include "fulbito/detail/math.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/teams/libero/attack/volley.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// What the support does at `pose`, with the ball at rest at `ball` for `stuck` [s].
std::optional<libero::Move> moveAt(const char* robot, const Pose2& pose, Vec2 ball, double stuck) {
  const libero::Pitch pitch(test::infoOf(3, robot));
  Observation seen;
  seen.team_size = 3;
  seen.own[2] = test::standingAt(pose);
  seen.ball.position = ball;
  libero::BallForecast forecast;
  forecast.take(seen.ball, {});
  libero::Picture picture{seen, pitch, forecast, stuck};
  libero::Memory memory;
  return libero::support::goForward(picture, 2, memory);
}

/// The place to which it goes forward.
std::optional<Vec2> forward(const char* robot, Vec2 ball, double stuck) {
  const auto move = moveAt(robot, {{-0.3, 0.0}, 0.0}, ball, stuck);
  return move ? move->place : std::nullopt;
}

}  // namespace

TEST_CASE("libero's support waits for rebounds, or with a run-up for a ball thrown across", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const Vec2 ball{0.375, 0.4 * side};
    const auto near = forward("vsss", ball, 0.0), back = forward("firasim", ball, 0.0);
    REQUIRE(near);
    REQUIRE(back);
    CHECK(side * near->y < 0.0);
    CHECK(side * back->y < 0.0);
    const libero::Pitch pitch(test::infoOf(3, "firasim"));
    CHECK(back->x < near->x - pitch.front);
    // The run-up takes about as long as a ball thrown at 0.5 m/s takes to the middle.
    const double way = norm(*back - Vec2{ball.x + 0.1, 0.0}) - pitch.front;
    CHECK(std::abs(timeAlong(pitch.pace, way, 0.0) - 0.4 / 0.5) < 0.15);
  }
}

TEST_CASE("from its place, libero's support shoots a ball that one robot throws, and one that both throw",
          "[unit]") {
  const MatchInfo info = test::infoOf(3, "firasim");
  const libero::Pitch pitch(info);
  const Vec2 mark = info.field.free_ball_mark;
  const auto place = forward("firasim", mark, 3.0);
  REQUIRE(place);
  for (const Vec2 thrown : {Vec2{0.14, -0.52}, Vec2{0.0, -0.53}}) {
    Observation seen;
    seen.team_size = 3;
    seen.own[2] = test::standingAt({*place, math::angleOf(pitch.theirGoal() - *place)});
    // Keepers follow the ball, so theirs stands on its side.
    seen.opponents[0] = test::standingAt({{0.71, 0.12}, math::kPi / 2});
    seen.opponents[1] = test::standingAt({{mark.x + pitch.front, mark.y}, math::kPi});
    seen.ball = {mark + thrown * 0.2, thrown, thrown};
    BallPrediction way;
    way.predict(BallCourse(info.field, info.ball, info.physics), seen.ball);
    libero::BallForecast ball;
    ball.take(seen.ball, way);
    CHECK(libero::bestVolley({seen, pitch, ball}, 2));
  }
}

TEST_CASE("libero's support goes forward when a ball that is stuck becomes a free ball", "[unit]") {
  const Vec2 ball{0.12, 0.62};
  CHECK_FALSE(forward("firasim", ball, 0.0));
  CHECK(forward("firasim", ball, 3.0));
  CHECK_FALSE(forward("firasim", {-0.12, 0.62}, 3.0));
  CHECK_FALSE(forward("vsss", ball, 3.0));
}

TEST_CASE("libero's support waits for the throw of the free ball, not of the ball that is stuck", "[unit]") {
  const Vec2 mark = test::infoOf(3, "firasim").field.free_ball_mark;
  for (const double side : {1.0, -1.0}) {
    const auto at_mark = forward("firasim", {mark.x, side * mark.y}, 3.0);
    REQUIRE(at_mark);
    CHECK(distance(*at_mark, *forward("firasim", {0.7, side * 0.62}, 3.0)) < 1e-9);
    CHECK(distance(*at_mark, *forward("firasim", {0.7, side * 0.62}, 0.0)) > 0.1);
    // There it looks at their goal, about where it will run, and not at the ball.
    const double goal = math::angleOf(Vec2{0.75, 0.0} - *at_mark);
    for (const double off : {0.3, -0.3}) {
      const auto move = moveAt("firasim", {*at_mark, goal + off}, {mark.x, side * mark.y}, 3.0);
      CHECK(move->twist.angular * off < 0.0);
    }
  }
}

}  // namespace fulbito
