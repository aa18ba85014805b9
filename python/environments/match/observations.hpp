#pragma once

#include <cstddef>
#include <span>

#include "fulbito/strategy.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Largest absolute value of an observed number of ObservationForm::kAbsolute.
inline constexpr float kObservedBound = 3.0f;

/// Writes what an agent sees as numbers (docs/environments.md has the tables).
class ObservationWriter {
 public:
  ObservationWriter(ObservationForm form, const MatchConfig& match);

  /// Numbers of one observation.
  std::size_t size() const { return size_; }
  /// Largest absolute value of its numbers.
  float bound() const;
  /// Numbers of what all robots of a team see alike; 0 if this form shares nothing.
  std::size_t sharedSize() const { return form_ == ObservationForm::kAbsolute ? stateSize() : 0; }
  /// Writes what they see alike, `sharedSize` numbers.
  void share(const Observation& seen, std::span<float> shared) const;
  /// Writes the observation of one robot of the team that sees it. An absent robot sees zeros.
  /// @param shared  as `share` wrote it
  /// @param out  `size` numbers
  /// @return how many numbers were clipped to the bound
  int write(const Observation& seen, std::span<const float> shared, std::size_t robot,
            std::span<float> out) const;
  /// The same for one robot.
  int write(const Observation& seen, std::size_t robot, std::span<float> out) const;

  /// Numbers of the state of a whole world.
  std::size_t stateSize() const;
  /// Writes ball, all robots and the game as kAbsolute has them, `stateSize` numbers.
  void writeState(const Observation& seen, std::span<float> out) const;

 private:
  class Numbers;
  void addRobot(const ObservedRobot& robot, Numbers& numbers) const;
  void addGame(const Observation& seen, Numbers& numbers) const;

  ObservationForm form_;
  FieldGeometry field_;
  RobotModel robot_;
  double half_seconds_;
  double per_place_;  ///< [1/m] scales of the numbers
  double per_speed_;  ///< [s/m]
  double per_yaw_;    ///< [s/rad]
  double per_wheel_;  ///< [s/rad]
  std::size_t team_;  ///< robots per team
  std::size_t size_;
};

}  // namespace fulbito
