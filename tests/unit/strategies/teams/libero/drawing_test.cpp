#include "strategies/teams/libero/drawing.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

bool starts(const DebugDrawing& drawing, Vec2 at) {
  return drawing.kind == DebugDrawing::Kind::kLine && distance(drawing.from, at) < 1e-9;
}

}  // namespace

TEST_CASE("libero names every robot that it draws, and plays the same without drawings", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto seen_team = test::liberoIn(info), unseen_team = test::liberoIn(info);
  Rng rng(9, test::kTestStream);
  for (int i = 0; i < 2000; ++i) {
    Observation seen = test::anything(rng, info);
    const TeamCommand unseen = unseen_team->decide(seen);
    CHECK(unseen.drawings.empty());
    seen.wants_drawings = true;
    const TeamCommand command = seen_team->decide(seen);
    for (std::size_t robot = 0; robot < 3; ++robot) {
      REQUIRE(command.robots[robot].twist.linear == unseen.robots[robot].twist.linear);
      REQUIRE(command.robots[robot].twist.angular == unseen.robots[robot].twist.angular);
    }
    // Each robot has its skill and the reason.
    const auto texts =
        std::count_if(command.drawings.begin(), command.drawings.end(),
                      [](const DebugDrawing& d) { return d.kind == DebugDrawing::Kind::kText; });
    const auto present =
        std::count_if(seen.own.begin(), seen.own.end(), [](const ObservedRobot& r) { return r.present; });
    CHECK(texts == 2 * present);
  }
}

TEST_CASE("libero draws a place for a robot that goes to one though a ball is brought at it", "[unit]") {
  // Deep in its half, a support does not block an opponent that dribbles at it, but waits at its place.
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  Observation seen;
  seen.wants_drawings = true;
  seen.since_restart = 5.0;
  seen.own[0] = test::standingAt({{-0.70, 0.0}, math::kPi / 2});
  seen.own[1] = test::standingAt({{-0.28, 0.29}, 0.0});
  seen.own[2] = test::standingAt({{-0.50, 0.24}, math::kPi / 2});
  seen.opponents[0] = test::standingAt({{-0.12, 0.33}, math::kPi});
  seen.ball.position = {-0.18, 0.32};
  seen.ball.velocity = {-0.5, -0.1};
  const TeamCommand command = team->decide(seen);
  const auto support = std::find(command.roles.begin(), command.roles.end(), std::uint8_t{3});
  REQUIRE(support != command.roles.end());
  const Vec2 place = seen.own[static_cast<std::size_t>(support - command.roles.begin())].state.pose.position;
  CHECK(place.x < -0.30);
  CHECK(std::any_of(command.drawings.begin(), command.drawings.end(),
                    [&](const DebugDrawing& drawing) { return starts(drawing, place); }));
}

}  // namespace fulbito
