// Private header of strategies: not installed.
#pragma once

#include "strategies/libero_ball.hpp"
#include "strategies/libero_pitch.hpp"
#include "strategies/libero_settings.hpp"

namespace fulbito::libero {

/// All that the skills look at in one tick.
struct Picture {
  const Observation& seen;
  const Pitch& pitch;
  const Settings& settings;
  const BallForecast& ball;
  double stuck = 0.0;  ///< [s] for which the ball has not left a circle of 10 cm: referees count so

  const RobotState& own(int i) const { return seen.own[static_cast<std::size_t>(i)].state; }
  bool ownPresent(int i) const { return seen.own[static_cast<std::size_t>(i)].present; }
  const RobotState& opponent(int i) const { return seen.opponents[static_cast<std::size_t>(i)].state; }
  bool opponentPresent(int i) const { return seen.opponents[static_cast<std::size_t>(i)].present; }
  /// How many opponents' centres are within `radius` [m] of a place.
  int opponentsNear(Vec2 place, double radius) const {
    int near = 0;
    for (int i = 0; i < seen.team_size; ++i) {
      if (opponentPresent(i) && squaredNorm(opponent(i).pose.position - place) < radius * radius) ++near;
    }
    return near;
  }
};

}  // namespace fulbito::libero
