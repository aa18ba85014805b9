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
};

}  // namespace fulbito::libero
