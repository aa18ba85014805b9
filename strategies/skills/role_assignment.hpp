#pragma once

#include <array>
#include <span>

#include "engine/core/base/team.hpp"

namespace fulbito {

/// Who does what, without flapping. Costs are seconds by custom. Every tick the assignment with the least sum
/// is looked for; it replaces the present one only when it is better by a margin, which is larger just after
/// a change, and never within the dwell time unless something happened (docs/skills.md).
class RoleAssignment {
 public:
  struct Settings {
    double margin = 0.2;        ///< [s] by which another assignment must be better
    double fresh_margin = 0.4;  ///< [s] added to it just after a change, shrinking to 0 over `settling`
    double settling = 2.0;      ///< [s]
    double dwell = 0.4;         ///< [s] without any change
  };
  using Costs = std::array<std::array<double, kMaxTeamSize>, kMaxTeamSize>;  ///< [robot][role]
  /// Cost of what must not be.
  static constexpr double kForbidden = 1e6;

  RoleAssignment() = default;
  explicit RoleAssignment(Settings settings) : settings_(settings) {}
  /// A new play: the next assignment is the best one, whatever was before.
  void reset() { known_ = false; }
  /// Roles 0 ... `count`-1 for robots 0 ... `count`-1, by number. `event`: something happened that makes the
  /// dwell time pointless (the ball jumped, contact was lost, a robot came or went).
  std::span<const int> assign(const Costs& costs, int count, double dt, bool event);
  /// Role of a robot, as last assigned.
  int roleOf(std::size_t robot) const { return roles_[robot]; }
  /// Robot with a role, as last assigned.
  std::size_t robotWith(int role) const;
  /// Changes so far (exchanges of roles count once).
  int changes() const { return changes_; }

 private:
  using Roles = std::array<int, kMaxTeamSize>;
  Settings settings_;
  Roles roles_{};
  int count_ = 0;
  double since_change_ = 1e9;
  int changes_ = 0;
  bool known_ = false;
};

}  // namespace fulbito
