#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/trial_score.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// Limits and rules of one trial.
struct TrialRules {
  double length_limit = 1.0;  ///< [m] L*
  double time_limit = 1.0;    ///< [s] T*
  double give_up = 8.0;       ///< multiple of T* at which the trial ends
  double stuck_after = 3.0;   ///< [s] time without motion that ends the trial
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;
};

/// Judges one navigation trial tick by tick. Deterministic: uses no clock and no random numbers.
class TrialReferee {
 public:
  TrialReferee(const Layout& layout, const FieldGeometry& field, const RobotModel& robot,
               const TrialRules& rules, double dt);

  /// Processes the world after a tick. The robot is the world's robot 0; `command` is its command in this
  /// tick.
  /// @return true when the trial is over
  bool observe(const WorldState& world, std::span<const ContactEvent> contacts, WheelSpeeds command);

  /// The score; complete once `observe` has returned true.
  TrialScore score() const;
  /// Whether the time that the rules leave is over without an arrival.
  bool late() const { return !score_.arrived && score_.time >= rules_.give_up * rules_.time_limit; }
  /// Whether there was a contact that the rules forbid: the trial cannot succeed any more.
  bool spoiled() const;

 private:
  void judgeContacts(std::span<const ContactEvent> contacts);
  void judgeObstacleContact(const ContactEvent& event);
  void measure(const WorldState& world, WheelSpeeds command);
  void watchProgress(const RobotState& robot);
  bool arrived(const RobotState& robot);
  double leastClearance(const WorldState& world) const;

  const Layout layout_;
  const FieldGeometry field_;
  const std::vector<Vec2> contour_;
  const RobotModel model_;
  const TrialRules rules_;
  const double dt_;
  TrialScore score_;
  RobotState last_;
  int ticks_ = 0;
  int pushed_tick_ = -1000000;  ///< last tick at which an obstacle pushed the robot
  double clearance_sum_ = 0.0;
  double jerk_sum_ = 0.0;
  std::optional<double> last_curvature_;
  WheelSpeeds last_command_, second_last_command_;
  Pose2 rest_pose_;
  int rest_tick_ = 0;
};

}  // namespace fulbito
