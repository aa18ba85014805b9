#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fulbito/strategy.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Largest absolute value of an observed number of ObservationForm::kAbsolute.
inline constexpr float kObservedBound = 3.0f;

/// Unit vectors of the headings of all robots of an observation, which several agents of a team share.
struct Facings {
  Facings() = default;
  explicit Facings(const Observation& seen);
  PerTeam<std::array<Vec2, kMaxTeamSize>> robots{};  ///< own, then opponents; 0 for absent ones
};

/// Writes what an agent sees as numbers (docs/environments.md has the tables).
class ObservationWriter {
 public:
  ObservationWriter(ObservationForm form, const MatchConfig& match);

  /// Numbers of one observation.
  std::size_t size() const { return size_; }
  /// Largest absolute value of its numbers.
  float bound() const;
  /// The facings of `seen` if this form needs them.
  Facings facingsOf(const Observation& seen) const {
    return form_ == ObservationForm::kAbsolute ? Facings(seen) : Facings();
  }
  /// Writes the observation of one robot of the team that sees it. An absent robot sees zeros.
  /// @param facings  `facingsOf(seen)`
  /// @param out  `size` numbers
  /// @return how many numbers were clipped to the bound
  int write(const Observation& seen, const Facings& facings, std::size_t robot, std::span<float> out) const;
  /// The same for one robot.
  int write(const Observation& seen, std::size_t robot, std::span<float> out) const {
    return write(seen, facingsOf(seen), robot, out);
  }

  /// Numbers of the state of a whole world.
  std::size_t stateSize() const;
  /// Writes ball, all robots and the game as kAbsolute has them, `stateSize` numbers.
  void writeState(const Observation& seen, std::span<float> out) const;

 private:
  class Numbers;
  void addRobot(const ObservedRobot& robot, Vec2 facing, Numbers& numbers) const;
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
