#pragma once

#include <optional>

#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito::test {

inline constexpr double kUp = 1.0, kDown = -1.0;  // side of the field on which a scene is played

inline Vec2 onSide(Vec2 v, double side) { return {v.x, side * v.y}; }

inline RobotState robotAt(Vec2 place, double heading, double side) {
  RobotState robot;
  robot.pose = {onSide(place, side), side * heading};
  return robot;
}

/// A picture with one own robot, one opponent and a resting ball.
struct WallScene {
  WallScene(Vec2 ball, Vec2 own, Vec2 opponent, double side) {
    seen.ball.position = onSide(ball, side);
    seen.own[0] = {true, robotAt(own, 2.0, side)};
    seen.opponents[0] = {true, robotAt(opponent, 3.0, side)};
    forecast.take(seen.ball, {});
  }

  Vec2 rel() const { return seen.ball.position - seen.own[0].state.pose.position; }
  /// What a skill does here.
  std::optional<libero::Move> move(libero::SkillFunction& skill) const {
    libero::Memory remembered = memory;
    return skill({seen, pitch, forecast, stuck, {}, free_balls_pay}, 0, remembered);
  }

  libero::Pitch pitch{matchInfo()};
  Observation seen;
  libero::BallForecast forecast;
  double stuck = 0.0;  // [s] for which the ball has been stuck
  bool free_balls_pay = false;
  libero::Memory memory;  // of the robot, before the tick
};

inline constexpr Vec2 kAtCut{-0.725, 0.56};      // at the end wall, where the corner triangle begins
inline constexpr Vec2 kAtEndWall{-0.728, 0.45};  // along the end wall, toward the own goal

}  // namespace fulbito::test
