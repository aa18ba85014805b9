#include "tournament/book/play_start.hpp"

#include <cmath>
#include <ctime>
#include <set>

#include "fulbito/detail/math.hpp"
#include "referee/geometry/placed_body.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

MatchConfig matchOf(const std::string& rules) {
  const auto match = MatchConfig::standard("idle", "idle", rules);
  REQUIRE(match);
  return *match;
}

PlacedBody bodyOf(const RobotModel& robot, const Pose2& pose) {
  return {pose.position, math::unit(pose.heading), robot.length / 2, robot.width / 2};
}

std::vector<PlacedBody> bodiesOf(const MatchConfig& match, const Placement& placement) {
  std::vector<PlacedBody> bodies;
  for (const auto& team : placement.robots) {
    for (const auto& pose : team) {
      if (pose) bodies.push_back(bodyOf(match.robot.robot, *pose));
    }
  }
  return bodies;
}

}  // namespace

TEST_CASE("states from play: all on the field, nobody overlaps, the ball rolls outside the goals", "[unit]") {
  for (const char* rules : {"vsss-3v3", "vsss-5v5"}) {
    const MatchConfig match = matchOf(rules);
    std::set<std::pair<double, double>> balls;
    double x = 0.0, y = 0.0, robot_x = 0.0, robot_y = 0.0;
    constexpr int kStarts = 60;
    int robots = 0;
    for (std::uint64_t turn = 0; turn < kStarts; ++turn) {
      INFO(rules << " " << turn);
      const auto found = playStart({StartKind::kPlay, 1, turn}, match);
      REQUIRE(found);
      const auto bodies = bodiesOf(match, *found);
      REQUIRE(bodies.size() == 2 * static_cast<std::size_t>(match.rules.team_size));
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        CHECK(onField(match.field, bodies[i]));
        CHECK(distanceTo(bodies[i], found->ball) > match.robot.ball.radius);
        for (std::size_t j = 0; j < i; ++j) CHECK(apart(bodies[i], bodies[j], 0.0));
        robot_x += std::abs(bodies[i].centre.x) / match.field.length;
        robot_y += std::abs(bodies[i].centre.y) / match.field.width;
        ++robots;
      }
      CHECK(std::abs(found->ball.x) + match.robot.ball.radius < match.field.length / 2);
      CHECK(norm(found->ball_velocity) >= 0.1);
      balls.insert({found->ball.x, found->ball.y});
      x += std::abs(found->ball.x) / match.field.length;
      y += std::abs(found->ball.y) / match.field.width;
    }
    CHECK(balls.size() == kStarts);
    // Mean distances from the centre over the field's dimensions; 1/4 for a uniform distribution.
    INFO("ball " << x / kStarts << " " << y / kStarts << ", robots " << robot_x / robots << " "
                 << robot_y / robots);
    for (const double mean : {x / kStarts, y / kStarts, robot_x / robots, robot_y / robots}) {
      CHECK(mean > 0.08);
      CHECK(mean < 0.4);
    }
  }
}

TEST_CASE("states from play favour no side", "[unit]") {
  const MatchConfig match = matchOf("vsss-3v3");
  double ball = 0.0;
  constexpr int kStarts = 200;
  for (std::uint64_t turn = 0; turn < kStarts; ++turn)
    ball += playStart({StartKind::kPlay, 4, turn}, match)->ball.x;
  // The standard error of the mean is about 0.4 m / sqrt(200).
  CHECK(std::abs(ball / kStarts) < 4 * 0.4 / std::sqrt(kStarts));
}

TEST_CASE("a team that is absent has no robots in a state from play", "[unit]") {
  MatchConfig match = matchOf("vsss-3v3");
  match.present[1] = false;
  const auto found = playStart({StartKind::kPlay, 1, 0}, match);
  REQUIRE(found);
  CHECK(bodiesOf(match, *found).size() == 3);
}

TEST_CASE("a state from play costs less than 20 ms on average", "[unit]") {
  const MatchConfig match = matchOf("vsss-3v3");
  constexpr int kStarts = 50;
  const std::clock_t begun = std::clock();  // CPU time, because other processes may use the processor too
  for (std::uint64_t turn = 0; turn < kStarts; ++turn) REQUIRE(playStart({StartKind::kPlay, 9, turn}, match));
  const double mean = 1e3 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC / kStarts;
  INFO(mean << " ms per start");
#ifdef NDEBUG
  CHECK(mean < 20.0);
#endif
}

}  // namespace fulbito
