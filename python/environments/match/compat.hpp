#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "fulbito/strategy.hpp"

/// Observations, actions and rewards as in `VSS-v0` of rSoccer (Martins et al., RoboCup 2021), so that what
/// is trained there plays here. Quantities, scales and quirks are those of its version of 2024.
namespace fulbito {

inline constexpr std::size_t kCompatNumbers = 40;  ///< numbers of an observation
inline constexpr float kCompatBound = 1.2f;        ///< largest absolute value
inline constexpr std::size_t kCompatTerms = 4;     ///< goal, move, ball_grad, energy
inline constexpr std::size_t kCompatFigures = 6;   ///< goal_score, move, ball_grad, energy, goals of both

/// Writes the ball (4), each own robot (7) and each opponent (5).
/// @return how many numbers were clipped
int writeCompat(const Observation& seen, std::span<float> out);

/// Wheel speeds [rad/s] of an action: below 0.05 m/s a wheel stands.
WheelSpeeds compatWheels(const RobotModel& robot, std::span<const float> action);

/// What the reward of a step looks at, in the team's frame.
struct CompatMoment {
  BallState ball;
  RobotState robot;    ///< the agent
  WheelSpeeds wheels;  ///< [rad/s] its command
  double step = 0.0;   ///< [s] length of a step
};

/// The reward of one agent.
class CompatReward {
 public:
  explicit CompatReward(const FieldGeometry& field) : field_(field) {}

  /// A new episode begins.
  void begin();
  /// Adds the terms of a step to `terms`, kCompatTerms numbers. The ball's gradient counts from the second
  /// step on. After a goal no other term counts.
  /// @return whether the ball's centre is behind a goal line
  bool step(const CompatMoment& now, std::span<double> terms);
  /// The sums since the episode began: goal_score, move, ball_grad, energy, goals_blue, goals_yellow.
  const std::array<double, kCompatFigures>& sums() const { return sums_; }

 private:
  double gradient(Vec2 ball, double step);

  FieldGeometry field_;
  std::optional<double> potential_;  ///< of the ball in the last step
  std::array<double, kCompatFigures> sums_{};
};

}  // namespace fulbito
