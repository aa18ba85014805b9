#include <string>

#include "fulbito/detail/math.hpp"
#include "match/drills/drill.hpp"
#include "strategies/teams/libero/playbook/playbook.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/striker/wall_scene.hpp"

namespace fulbito {
namespace {

using test::kDown, test::kUp, test::WallScene;

constexpr Vec2 kAtSideWall{-0.62, 0.628};                // [m] ball in the own corner's part of the side wall
constexpr Vec2 kGoalSide{-0.05, -0.045};                 // [m] of the robot relative to the ball
constexpr Vec2 kAhead{0.055, -0.025}, kNear{0.1, -0.1};  // [m] of an opponent relative to the ball
constexpr double kLeans = 1.9, kAlong = 3.1;  // [rad] headings of an opponent, into and along the wall

/// A jam of our striker and an opponent that points to `heading`.
WallScene jam(Vec2 ball, double side, double heading, Vec2 own = kGoalSide, Vec2 opponent = kAhead) {
  WallScene scene(ball, ball + own, ball + opponent, side);
  scene.seen.own[0].state.pose.heading = side * 0.7;
  scene.seen.opponents[0].state.pose.heading = side * heading;
  scene.seen.since_restart = 10.0;
  scene.memory.press.jammed = 1.0;
  return scene;
}

}  // namespace

TEST_CASE("libero backs off from a wedged ball, and drives into it", "[unit]") {
  const libero::PlayBook book;
  for (const double side : {kUp, kDown}) {
    WallScene scene = jam(kAtSideWall, side, kLeans);
    // The last of so many moves, of which the `others` in the middle are those of another role.
    const auto at = [&](int ticks, int others = 0) {
      WallScene now = scene;
      libero::Move move;
      for (int i = 0; i < ticks; ++i) {
        const bool away = i > 0 && i <= others;
        const libero::Role role = away ? libero::Role::kSupport : libero::Role::kStriker;
        move = book.decide(role, {now.seen, now.pitch, now.forecast}, 0, now.memory);
        now.memory.press.jammed = 0.0;  // it moves
      }
      return move;
    };
    CHECK(std::string(at(1).skill) == "ram");
    CHECK(at(1).twist.linear == Approx(-scene.pitch.speed));
    CHECK(std::string(at(17).skill) == "ram");
    CHECK(at(17).twist.linear > 0.8 * scene.pitch.speed);
    CHECK(std::string(at(20).skill) != "ram");      // the blow is over, and nothing jams yet
    CHECK(std::string(at(20, 18).skill) != "ram");  // an interrupted one ends at the same time
    scene.seen.own[0].state.pose.heading += math::kPi;
    CHECK(at(1).twist.linear == Approx(scene.pitch.speed));
  }
}

TEST_CASE("libero rams only deep in its half, goal-side, and where nobody comes after it", "[unit]") {
  for (const double side : {kUp, kDown}) {
    const auto rams = [](const WallScene& scene) { return scene.move(libero::striker::ram).has_value(); };
    CHECK(rams(jam(kAtSideWall, side, kLeans)));
    CHECK_FALSE(rams(jam(kAtSideWall, side, kAlong)));                     // it would follow
    CHECK_FALSE(rams(jam(kAtSideWall, side, kAlong, kGoalSide, kNear)));   // so would one that is near
    CHECK_FALSE(rams(jam({-0.2, 0.628}, side, kLeans)));                   // not deep
    CHECK_FALSE(rams(jam({-0.728, 0.45}, side, kLeans, {0.045, -0.05})));  // not goal-side
    WallScene moving = jam(kAtSideWall, side, kLeans);
    moving.memory.press.jammed = 0.1;
    CHECK_FALSE(rams(moving));
    WallScene firm = jam(kAtSideWall, side, kLeans);
    firm.pitch = libero::Pitch(test::infoOf(3, "firasim"));
    CHECK_FALSE(rams(firm));
  }
}

TEST_CASE("libero's rams bring balls that an opponent presses out of its corner", "[unit]") {
  // Successes in 60 trials of the drill under pressure.
  const auto successes = [](const char* team) {
    DrillOptions options;
    options.team = *parseTeam(team);
    options.trials = 120;
    const auto reports = runDrills(builtInDrills(), {8}, options, {});
    REQUIRE(reports);
    int count = 0;
    for (const DrillTrial& trial : reports->front().trials)
      count += trial.start == 1 && trial.success ? 1 : 0;
    return count;
  };
  const int with = successes("libero"), without = successes("libero:without=ram");
  CAPTURE(with, without);
  CHECK(with > 40);
  CHECK(with > without + 15);
}

}  // namespace fulbito
