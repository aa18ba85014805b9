#pragma once

#include <optional>
#include <vector>

#include "experiments/trials/sensing.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/world.hpp"
#include "referee/trial/trial_referee.hpp"

namespace fulbito {

/// One trial that its caller drives: `observe`, then `step`, until `over`. It takes no notice of the
/// configured navigator.
class NavigationTrial {
 public:
  /// Builds the world and judges the layout. `config` must outlive the trial.
  /// Errors: kUsage or kBadInput if the layout does not fit the field or robot.
  static Result<NavigationTrial> create(const TrialConfig& config);

  /// What the robot knows before the next step. Valid until the next call.
  const NavigationScene& observe();
  /// Plays one control tick with these wheel speeds [rad/s], rounded as the physics profile says; false once
  /// the trial is over.
  bool step(WheelSpeeds wanted);

  bool over() const { return over_; }
  /// The true state.
  const World& world() const { return world_; }
  /// The command of the last step, rounded.
  WheelSpeeds command() const { return command_; }
  /// [s] simulated so far.
  double seconds() const;
  /// Running hash of all states so far.
  std::uint64_t hash() const { return hash_.value(); }
  /// The score so far; complete once the trial is over.
  TrialScore score() const { return referee_.score(); }
  /// Whether a forbidden contact has spoiled it: it goes on, but cannot succeed any more.
  bool spoiled() const { return referee_.spoiled(); }
  /// Whether its end was the limit of time.
  bool late() const { return over_ && referee_.late(); }
  /// [m] The L* path: the shortest for the robot's centre.
  const std::vector<Vec2>& limitPath() const { return limit_path_; }

 private:
  struct LimitPath;
  NavigationTrial(const TrialConfig& config, World&& world, LimitPath&& limit);

  const TrialConfig* config_;
  World world_;
  std::vector<Vec2> limit_path_;
  TrialReferee referee_;
  Sensing sensing_;
  std::optional<SonarSight> sonars_;
  NavigationScene scene_;
  StateHash hash_;
  WheelSpeeds command_;
  bool over_ = false;
};

}  // namespace fulbito
