#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/match.hpp"
#include "fulbito/models.hpp"
#include "fulbito/strategy.hpp"
#include "referee/restarts/restart_call.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {

inline MatchConfig matchOf(const char* blue, const char* yellow, const char* rules, double half_seconds) {
  MatchConfig config;
  config.teams = {*parseTeam(blue), *parseTeam(yellow)};
  config.rules = *loadRules(rules);
  config.rules.half_seconds = half_seconds;
  config.field = *loadField(config.rules.field);
  config.robot = *loadRobot("vsss");
  config.physics = *loadPhysics("standard");
  return config;
}

/// The scene itself, or with `side` -1 its mirror image across the long axis.
inline Placement mirrored(Placement scene, double side) {
  scene.ball.y *= side;
  scene.ball_velocity.y *= side;
  for (TeamPoses& team : scene.robots) {
    for (auto& pose : team) {
      if (pose) pose = Pose2{{pose->position.x, side * pose->position.y}, side * pose->heading};
    }
  }
  return scene;
}

/// A match that starts with `scene`.
inline Match matchFrom(MatchConfig config, const Placement& scene) {
  config.start = scene;
  auto match = Match::create(config);
  REQUIRE(match);
  return std::move(*match);
}

/// The match after `seconds` from `scene`, with libero as blue.
inline Match playedFrom(const Placement& scene, double seconds, const char* yellow = "idle",
                        const char* model = "vsss") {
  MatchConfig config = matchOf("libero", yellow, "vsss-3v3", 10.0);
  config.robot = *loadRobot(model);
  Match match = matchFrom(config, scene);
  while (match.seconds() < seconds && match.step()) {
  }
  return match;
}

/// Checks that libero concedes no goal in `seconds` from `scene` and from its mirror image.
inline void checkHolds(const Placement& scene, double seconds, const char* yellow = "idle") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    CHECK(playedFrom(mirrored(scene, side), seconds, yellow).referee().score[1] == 0);
  }
}

/// Time [s] at which a single robot has scored; 10 if it has not.
inline double scoresAlone(Vec2 ball, const Pose2& robot, double side, const char* model = "vsss") {
  auto config = matchOf("libero", "idle", "vsss-3v3", 20.0);
  config.robot = *loadRobot(model);
  config.rules.stuck.seconds = config.rules.stuck.area_seconds = 20.0;
  Placement scene;
  scene.ball = ball;
  scene.robots[0][1] = robot;
  Match match = matchFrom(config, mirrored(scene, side));
  while (match.seconds() < 10.0 && match.referee().score[0] == 0 && match.step()) {
  }
  return match.seconds();
}

/// The match after `seconds` from a restart of the team `takes`, which plays as `seat` with robots of
/// `model`.
inline Match playedFromRestart(RestartKind kind, const char* takes, const char* against, TeamId seat,
                               const char* model, double seconds) {
  const bool blue = seat == TeamId::kBlue;
  MatchConfig config = matchOf(blue ? takes : against, blue ? against : takes, "vsss-3v3", 10.0);
  config.robot = *loadRobot(model);
  config.opening = makeCall(refereeSetup(config), {}, {kind, seat, {}, nullptr});
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->seconds() < seconds && match->step()) {
  }
  return std::move(*match);
}

/// Positions of libero's robots, the chaser's and the ball 0.1 s after a restart, with libero as `seat`.
inline std::vector<Vec2> afterRestart(RestartKind kind, bool ours, TeamId seat) {
  MatchConfig config = matchOf("libero", "chaser", "vsss-3v3", 10.0);
  if (seat == TeamId::kYellow) std::swap(config.teams[0], config.teams[1]);
  config.placement_error = {0.0, 0.0};
  const double own = seat == TeamId::kBlue ? -1.0 : 1.0;
  config.opening = makeCall(refereeSetup(config), {},
                            {kind, ours ? seat : other(seat), {ours ? -own * 0.3 : own * 0.3, 0.3}, nullptr});
  auto match = Match::create(config);
  REQUIRE(match);
  for (int tick = 0; tick < 6; ++tick) match->step();
  std::vector<Vec2> bodies{match->world().balls.front().position};
  for (const TeamId team : {seat, other(seat)}) {
    for (std::size_t i = 0; i < match->ids().size(); ++i) {
      if (match->ids()[i].team == team) bodies.push_back(match->world().robots[i].pose.position);
    }
  }
  return bodies;
}

inline MatchInfo infoOf(int team_size, const char* robot = "vsss") {
  MatchInfo info;
  info.field = *loadField(team_size == 3 ? "vsss-3v3" : "vsss-5v5");
  info.robot = loadRobot(robot)->robot;
  info.ball = loadRobot(robot)->ball;
  info.rules.team_size = team_size;
  return info;
}

/// A libero in which a match has begun.
inline std::unique_ptr<Strategy> liberoIn(const MatchInfo& info) {
  auto team = makeTeam(*parseTeam("libero"));
  REQUIRE(team);
  (*team)->begin(info);
  return std::move(*team);
}

inline ObservedRobot standingAt(const Pose2& pose) {
  ObservedRobot robot;
  robot.present = true;
  robot.state.pose = pose;
  return robot;
}

/// A random observation.
inline Observation anything(Rng& rng, const MatchInfo& info) {
  const double x = info.field.length / 2 + 0.09, y = info.field.width / 2;
  Observation seen;
  seen.team_size = info.rules.team_size;
  const auto put = [&](ObservedRobot& robot) {
    robot.present = rng.uniform(0.0, 1.0) < 0.8;
    robot.state.pose = {{rng.uniform(-x, x), rng.uniform(-y, y)}, rng.uniform(-3.14, 3.14)};
    robot.state.velocity = {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
    robot.state.angular_velocity = rng.uniform(-30.0, 30.0);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(info.rules.team_size); ++i) {
    put(seen.own[i]);
    put(seen.opponents[i]);
  }
  seen.ball.position = {rng.uniform(-x, x), rng.uniform(-y, y)};
  seen.ball.velocity = {rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
  // Some observations are degenerate: a robot on the ball, or a ball in a corner.
  if (rng.uniform(0.0, 1.0) < 0.1) seen.own[1].state.pose.position = seen.ball.position;
  if (rng.uniform(0.0, 1.0) < 0.1) seen.ball = {{x, y}, {}, {}};
  seen.since_restart = rng.uniform(0.0, 1.0);
  seen.restart = static_cast<RestartKind>(static_cast<int>(rng.uniform(0.0, 5.99)));
  seen.restart_is_ours = rng.uniform(0.0, 1.0) < 0.5;
  return seen;
}

/// The observation mirrored across the long axis.
inline Observation acrossAxis(Observation seen) {
  const auto flip = [](Vec2& v) { v.y = -v.y; };
  const auto robots = [&](auto& team) {
    for (ObservedRobot& robot : team) {
      flip(robot.state.pose.position);
      flip(robot.state.velocity);
      robot.state.pose.heading = -robot.state.pose.heading;
      robot.state.angular_velocity = -robot.state.angular_velocity;
    }
  };
  robots(seen.own);
  robots(seen.opponents);
  flip(seen.ball.position);
  flip(seen.ball.velocity);
  return seen;
}

}  // namespace fulbito::test
