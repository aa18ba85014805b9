#pragma once

#include <array>
#include <optional>

#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/situation/ball.hpp"
#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// When and where a robot can reach the ball.
struct Interception {
  double time = 0.0;  ///< [s]
  Vec2 ball = {};     ///< [m] the ball's position then
};

/// All that the skills use in one tick.
struct Picture {
  const Observation& seen;
  const Pitch& pitch;
  const BallForecast& ball;
  double stuck = 0.0;  ///< [s] time that the ball has stayed in a circle, as referees measure it
  /// [s] time for which each own robot still counts as disputing the ball; 0: it has not touched it recently.
  std::array<double, kMaxTeamSize> dispute_left{};
  /// Whether free balls in the opponents' half are worth a wait in this match.
  bool free_balls_pay = false;
  /// Whether the field players withdraw from a stall in the opponents' half.
  bool stall_given_up = false;
  /// @{ What the choice of roles adds.
  int keeper = -1;   ///< the robot that keeps goal; -1: none
  int striker = -1;  ///< the robot that goes for the ball; -1: none
  /// Of each field player without the ball: how many of them have smaller numbers.
  std::array<int, kMaxTeamSize> rank{};
  /// Of each field player; empty for others.
  std::array<std::optional<Interception>, kMaxTeamSize> interceptions{};
  /// @}
  const Tuning& tuning = pitch.tuning;

  const RobotState& own(int i) const { return seen.own[static_cast<std::size_t>(i)].state; }
  bool ownPresent(int i) const { return seen.own[static_cast<std::size_t>(i)].present; }
  const RobotState& opponent(int i) const { return seen.opponents[static_cast<std::size_t>(i)].state; }
  bool opponentPresent(int i) const { return seen.opponents[static_cast<std::size_t>(i)].present; }
  /// The ball [m] as seen from an own robot.
  Vec2 ballFrom(int i) const { return ball.now().position - own(i).pose.position; }
  bool disputes(int i) const { return dispute_left[static_cast<std::size_t>(i)] > 0.0; }
  /// Whether a penalty of either team has just begun.
  bool isPenalty() const {
    return seen.restart == RestartKind::kPenalty && seen.since_restart <= tuning.patience;
  }
  /// Whether a free ball of either team has just begun.
  bool disputesFreeBall() const {
    return seen.restart == RestartKind::kFreeBall && seen.since_restart < tuning.patience;
  }
  /// Number of opponents whose centres are within `radius` [m] of `place`.
  int opponentsNear(Vec2 place, double radius) const {
    int near = 0;
    for (int i = 0; i < seen.team_size; ++i) {
      if (opponentPresent(i) && squaredNorm(opponent(i).pose.position - place) < radius * radius) ++near;
    }
    return near;
  }
  /// Whether an opponent is in its own area, or one is outside it.
  bool hasOpponent(bool in_area) const {
    for (int i = 0; i < seen.team_size; ++i) {
      if (opponentPresent(i) && isInArea(pitch.field, opponent(i).pose.position, false) == in_area)
        return true;
    }
    return false;
  }
};

}  // namespace fulbito::libero
