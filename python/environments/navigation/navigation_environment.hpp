#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/trials/navigation_trial.hpp"
#include "experiments/trials/trial_recorder.hpp"
#include "python/environments/episodes.hpp"
#include "python/environments/navigation/sight.hpp"

namespace fulbito {

/// How an agent drives its robot.
enum class NavigationControl : std::uint8_t {
  kWheels,   ///< 2 numbers: left and right wheel, as shares of their greatest speed
  kTwist,    ///< 2 numbers: forward speed and yaw rate, as shares of the greatest
  kHeading,  ///< 2 numbers: a direction seen from that of the goal, over pi, and the speed from -1: none to
             ///< 1: the greatest. The follower of the built-in navigators drives it
};

/// @{ The terms of the reward, in the order of the weights; docs/environments.md describes them.
inline constexpr std::array<std::string_view, 7> kNavigationTerms{"success", "failure",   "time",  "goal",
                                                                  "contact", "clearance", "effort"};
enum class NavigationTerm : std::uint8_t { kSuccess, kFailure, kTime, kGoal, kContact, kClearance, kEffort };
using NavigationWeights = std::array<double, kNavigationTerms.size()>;
inline constexpr NavigationWeights kNavigationWeights{10.0, 5.0, 1.0, 5.0, 5.0, 0.0, 0.0};
/// @}

/// What an environment of navigation is made with.
struct NavigationSettings {
  std::string suite = "corner";  ///< as `compare` names it
  std::optional<Layout> layout;  ///< instead of the suite's: the same in all episodes
  double speed = 1.0;            ///< [m/s] top speed of the robot
  NavigationControl control = NavigationControl::kWheels;
  int ticks = 1;      ///< control ticks per step, 1 ... 60
  bool train = true;  ///< layouts to train on, whose seeds `compare` does not use
  bool ends_at_contact =
      false;  ///< a forbidden contact ends the episode; else it only fails it, as in `compare`
  StartHeading heading = StartHeading::kLayout;  ///< of the robot at the start
  SensorModel sensors;
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  NavigationWeights weights = kNavigationWeights;
};

/// A robot that drives to a goal among obstacles, as an environment. Each episode is one trial of `compare`,
/// with its sensors, contacts and score. It ends as the trial does: terminated when the robot arrives, is
/// stuck or leaves the field, truncated at the trial's limit of time.
///
/// Figures: success, outcome (`TrialOutcome`), time [s], time-ratio (T/T*), length [m], length-ratio (L/L*),
/// contacts, clearance [m] (least so far), layout (number).
///
/// `EpisodeStart::text` is empty, for a layout drawn from the seed, or `layout N of seed S`: that layout as
/// `compare` has it, whatever the split. Without a seed it is the default of `compare`. Layouts with names,
/// as in the suite `cases`, also go by name: `layout fig4-wall`.
class NavigationEnvironment final : public EpisodeSource {
 public:
  /// Errors: kUsage for names and ranges; those of robot, physics and layout.
  static Result<std::unique_ptr<NavigationEnvironment>> create(const NavigationSettings& settings);

  const EpisodeShape& shape() const override { return shape_; }
  Result<void> begin(const EpisodeStart& start, const EpisodeView& out) override;
  Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out) override;
  Result<void> record(const std::string& file) override;
  Result<Canvas> picture(int width) override;

 private:
  class Steering;
  explicit NavigationEnvironment(const NavigationSettings& settings);
  Result<void> place(const EpisodeStart& start);
  WheelSpeeds wheelsFor(const NavigationScene& scene);
  double nearness() const;
  void reward(double seconds, bool over, const EpisodeView& out);
  void tell(const EpisodeView& out);
  double goalDistance() const;

  NavigationSettings settings_;
  EpisodeShape shape_;
  Comparison plan_;     ///< one block: the suite at the speed
  TrialConfig config_;  ///< of the present trial, which refers to it
  std::optional<NavigationTrial> trial_;
  const NavigationScene* scene_ = nullptr;
  NavigationSight sight_;
  std::optional<Pilot> pilot_;    ///< for kHeading
  Steering* steering_ = nullptr;  ///< the pilot's navigator
  std::string file_;              ///< into which the next episode is recorded; empty: into none
  std::optional<TrialRecorder> recorder_;
  std::array<double, 2> action_{}, last_action_{};
  double direction_ = 0.0;  ///< [rad] for kHeading, the same for all ticks of a step
  double effort_ = 0.0;     ///< change of the action in this step
  double near_ = 0.0;       ///< [s] how near the robot was to obstacles in this step, over its time
  double distance_ = 0.0;   ///< [m] of the goal at the last step
  int contacts_ = 0;
  std::vector<Vec2> driven_;  ///< for pictures
};

}  // namespace fulbito
