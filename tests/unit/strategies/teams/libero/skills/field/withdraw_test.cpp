#include <cmath>
#include <utility>
#include <vector>

#include "fulbito/statistics.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Shares of two teams' play against each other: how often the ball is at a wall, and how often robots stand.
/// Whole matches, since the teams first have to see that the other answers.
std::pair<double, double> wallAndSlow(const char* blue, const char* yellow, const char* robot) {
  MatchConfig config = test::matchOf(blue, yellow, "vsss-3v3", 300.0);
  config.robot = *loadRobot(robot);
  constexpr int kMatches = 2;
  double wall = 0.0, slow = 0.0;
  for (std::uint64_t seed = 1; seed <= kMatches; ++seed) {
    config.seed = seed;
    auto match = Match::create(config);
    REQUIRE(match);
    StatisticsObserver watcher;
    match->watch(watcher);
    while (match->step()) {
    }
    const MatchStatistics& counted = watcher.statistics();
    const TeamPlay& play = counted.teams[0].play;
    wall += static_cast<double>(counted.wall_ticks) / static_cast<double>(counted.play_ticks) / kMatches;
    slow += static_cast<double>(play.slow_ticks) / static_cast<double>(play.robot_ticks) / kMatches;
  }
  return {wall, slow};
}

}  // namespace

TEST_CASE("libero's field players leave a stall that is given up, and stand apart between ball and goal",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const libero::Pitch pitch(test::infoOf(5));
    libero::BallForecast ball;
    Observation seen;
    seen.ball.position = {0.6, side * 0.6};
    ball.take(seen.ball, {});
    libero::Picture picture{seen, pitch, ball};
    picture.keeper = 0, picture.striker = 1;
    picture.rank[3] = 1;
    libero::Memory memory;
    CHECK_FALSE(libero::field::withdraw(picture, 1, memory));
    picture.stall_given_up = true;
    std::vector<Vec2> places;
    for (int i = 1; i <= 3; ++i) {
      seen.own[static_cast<std::size_t>(i)] = test::standingAt({{0.5, side * 0.55}, 0.0});
      const auto move = libero::field::withdraw(picture, i, memory);
      REQUIRE(move);
      REQUIRE(move->place);
      const Vec2 place = *move->place;
      CHECK(place.x < seen.ball.position.x);
      CHECK(distance(place, seen.ball.position) > 2 * pitch.tuning.rival_near);
      CHECK(std::abs(place.y) < pitch.half_width - pitch.robot_half);
      for (const Vec2 other : places) CHECK(distance(place, other) > pitch.bodies);
      places.push_back(place);
    }
  }
}

TEST_CASE("two liberos that give up stalls play more in the open, and stand less", "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    const auto [wall, slow] = wallAndSlow("libero", "libero", robot);
    const auto [former_wall, former_slow] =
        wallAndSlow("libero:without=withdraw", "libero:without=withdraw", robot);
    CHECK(wall < former_wall);
    CHECK(slow < 0.85 * former_slow);
  }
}

}  // namespace fulbito
