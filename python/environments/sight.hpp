#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fulbito/strategy.hpp"
#include "match/drills/drill.hpp"

namespace fulbito {

/// One number of an observation.
struct SightEntry {
  std::string name;
  std::string unit;  ///< empty: a share or a direction
  std::string meaning;
};

/// Numbers lie within -kSightBound ... kSightBound.
inline constexpr float kSightBound = 4.0f;

/// The game as one robot sees it, in numbers with x ahead of the robot. They are the same for all drills and
/// for matches, so that a policy can learn one after the other.
class RobotSight {
 public:
  /// @param team  robots per team
  explicit RobotSight(std::size_t team) : team_(team) {}

  /// All numbers, in their order.
  std::vector<SightEntry> entries() const;
  std::size_t size() const;

  /// What an observation is made from.
  struct Moment {
    const Observation& seen;
    const FieldGeometry& field;
    const RobotModel& model;
    std::size_t robot = 0;  ///< that sees it; it is present
    DrillTask task = DrillTask::kPlay;
    const Exercise* exercise = nullptr;  ///< null without a task
    double elapsed = 0.0;                ///< share of the time that is over
  };
  /// Writes `size` numbers.
  /// @return how many of them were clipped to the bound
  int write(const Moment& moment, std::span<float> out) const;

 private:
  std::size_t team_;
};

}  // namespace fulbito
