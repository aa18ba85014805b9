#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero keeps its places legal at every restart", "[unit]") {
  for (const int size : {3, 5}) {
    const MatchInfo info = test::infoOf(size);
    const auto team = test::liberoIn(info);
    for (int kind = 0; kind < 5; ++kind) {
      for (const bool ours : {true, false}) {
        PlacementRequest request{static_cast<RestartKind>(kind), ours, {-0.375, 0.4}, {}, {}};
        const auto placed = team->place(request);
        REQUIRE(placed);
        for (const auto& pose : placed->robots) {
          if (pose) CHECK(insideField(info.field, pose->position, 0.03));
        }
      }
    }
  }
}

TEST_CASE("libero begins restarts alike on both sides", "[unit]") {
  for (const RestartKind kind :
       {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kPenalty, RestartKind::kGoalKick}) {
    for (const bool ours : {true, false}) {
      const auto blue = test::afterRestart(kind, ours, TeamId::kBlue);
      const auto yellow = test::afterRestart(kind, ours, TeamId::kYellow);
      REQUIRE(blue.size() == yellow.size());
      // Rotated if the places of the rules are alike on both sides, otherwise mirrored like them.
      const bool turned = kind == RestartKind::kKickOff;
      for (std::size_t i = 0; i < blue.size(); ++i) {
        CAPTURE(static_cast<int>(kind), ours, i);
        CHECK(yellow[i].x == Approx(-blue[i].x).margin(1e-3));
        CHECK(yellow[i].y == Approx(turned ? -blue[i].y : blue[i].y).margin(1e-3));
      }
    }
  }
}

TEST_CASE("libero plays kick-offs to either hand in turn", "[unit]") {
  for (const int size : {3, 5}) {
    const auto team = test::liberoIn(test::infoOf(size));
    for (const bool ours : {true, false}) {
      PlacementRequest request{RestartKind::kKickOff, ours, {}, {}, {}};
      const auto one = team->place(request), next = team->place(request);
      REQUIRE(one);
      REQUIRE(next);
      for (const std::size_t i : {1, 2}) {
        CAPTURE(size, ours, i);
        // In small matches robot 1 kicks straight, and is in the way of a straight kick, whatever the hand.
        CHECK((one->robots[i]->position.y == 0.0) == (size == 3 && i == 1));
        CHECK(one->robots[i]->position.x == Approx(next->robots[i]->position.x));
        CHECK(one->robots[i]->position.y == Approx(-next->robots[i]->position.y));
      }
    }
  }
}

TEST_CASE("libero kicks off straight ahead, or past a crowd", "[unit]") {
  for (const int size : {3, 5}) {
    for (const char* robot : {"vsss", "firasim"}) {
      const MatchInfo info = test::infoOf(size, robot);
      const auto placed = test::liberoIn(info)->place({RestartKind::kKickOff, true, {}, {}, {}});
      REQUIRE(placed);
      const Pose2 taker = *placed->robots[1];
      CAPTURE(size, robot);
      CHECK((taker.position.y == 0.0) == (size == 3));
      CHECK(cross(math::unit(taker.heading), -taker.position) == Approx(0.0).margin(1e-9));
      CHECK(dot(math::unit(taker.heading), -taker.position) > 0.0);
      // The kick goes to the side of the support, if to any.
      CHECK(taker.position.y * placed->robots[2]->position.y <= 0.0);
      const double gap = norm(taker.position) - info.robot.length / 2 - info.ball.radius;
      CHECK(gap >= 0.0);
      // An opponent outside the circle has a much longer way to the ball.
      CHECK(gap < (info.field.centre_circle_radius - info.robot.length / 2) / 4);
    }
  }
}

TEST_CASE("libero waits for a kick-off in its way and where a slanting one goes", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  for (const Vec2 taker : {Vec2{0.2, 0.0}, Vec2{0.165, 0.113}, Vec2{0.165, -0.113}}) {
    PlacementRequest request{RestartKind::kKickOff, false, {}, {}, TeamPlacement{}};
    (*request.opponents)[1] = Pose2{taker, 3.14};
    (*request.opponents)[2] = Pose2{{0.4, 0.0}, 3.14};
    const auto placed = team->place(request);
    REQUIRE(placed);
    const Vec2 meeter = placed->robots[1]->position, support = placed->robots[2]->position;
    CHECK(meeter.y == 0.0);
    // The kick goes from the taker through the ball, so to the other side of the middle.
    if (taker.y != 0.0) CHECK(support.y * taker.y < 0.0);
    CHECK(std::abs(support.y) > info.field.centre_circle_radius);
    CHECK(norm(meeter) < norm(support));
    for (const Vec2 place : {meeter, support}) {
      CHECK(norm(place) >= info.field.centre_circle_radius);
      CHECK(place.x < -info.robot.length / 2);
    }
  }
}

TEST_CASE("libero awaits their goal kick in its own half, on the ball's side", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  for (const double side : {1.0, -1.0}) {
    const auto placed = team->place({RestartKind::kGoalKick, false, {0.6, side * 0.35}, {}, {}});
    REQUIRE(placed);
    for (const std::size_t i : {1, 2}) {
      CHECK(placed->robots[i]->position.x < -info.robot.circumradius());
      CHECK(placed->robots[i]->position.y * side > 0.0);
    }
  }
}

TEST_CASE("libero's keeper takes a goal kick with a run-up toward the side wall in their half", "[unit]") {
  for (const int size : {3, 5}) {
    for (const char* robot : {"vsss", "firasim"}) {
      const MatchInfo info = test::infoOf(size, robot);
      const auto team = test::liberoIn(info);
      for (const double side : {1.0, -1.0}) {
        CAPTURE(size, robot, side);
        const Vec2 ball{-info.field.length / 2 + info.field.goal_area_depth, side * 0.35};
        const auto placed = team->place({RestartKind::kGoalKick, true, ball, {}, {}});
        REQUIRE(placed);
        const Pose2 keeper = *placed->robots[0];
        CHECK(keeper.position.x < ball.x);
        CHECK(std::abs(keeper.position.y) < std::abs(ball.y));
        CHECK(insideField(info.field, keeper.position, info.robot.circumradius()));
        // A run-up, and yet between ball and goal.
        CHECK(distance(keeper.position, ball) > info.robot.length / 2 + info.ball.radius + 0.02);
        CHECK(distance(keeper.position, ball) < 0.12);
        const Vec2 ahead = math::unit(keeper.heading);
        CHECK(cross(ahead, ball - keeper.position) == Approx(0.0).margin(1e-9));
        CHECK(dot(ahead, ball - keeper.position) > 0.0);
        const double x =
            ball.x + (side * info.field.width / 2 - ball.y) * ahead.x / ahead.y;  // at the side wall
        CHECK(x > 0.0);
        CHECK(x < info.field.length / 2);
      }
    }
  }
}

TEST_CASE("libero's taker of a penalty runs up on the line to the inside of a post", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    const MatchInfo info = test::infoOf(3, robot);
    for (const double side : {1.0, -1.0}) {
      PlacementRequest request{RestartKind::kPenalty, true, {0.375, 0.0}, {}, {}};
      request.defaults[2] = Pose2{{-0.1, side * 0.4}, 0.0};
      const auto placed = test::liberoIn(info)->place(request);
      REQUIRE(placed);
      const Pose2 taker = *placed->robots[1];
      CHECK(distance(taker.position, request.ball) > 0.4);
      const Vec2 ahead = math::unit(taker.heading);
      CHECK(cross(ahead, request.ball - taker.position) == Approx(0.0).margin(1e-9));
      const double y = (info.field.length / 2 - request.ball.x) * ahead.y / ahead.x;
      // the support waits on that side
      CHECK(side * y < info.field.goal_width / 2 - info.ball.radius);
      CHECK(side * y > info.field.goal_width / 2 - 3 * info.ball.radius);
      CHECK(side * placed->robots[2]->position.y > 0.0);
    }
  }
}

}  // namespace fulbito
