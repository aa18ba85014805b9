#pragma once

#include <memory>

#include "fulbito/recorder.hpp"
#include "match/drills/trial_run.hpp"
#include "python/environments/agent_team.hpp"
#include "python/environments/drills/progress.hpp"
#include "python/environments/drills/settings.hpp"
#include "python/environments/episodes.hpp"

namespace fulbito {

/// A drill as a task for one agent: each episode is a trial, judged by the drill's own judge. It ends where
/// the trial ends: terminated with a verdict, truncated when the time is over without one.
///
/// Figures: success (1 once the drill counts it), time [s] since the signal, or of the success; ideal [s] (a
/// lower bound of the time, 0 if there is none), counted (0: a trial that the drill does not count), start
/// (index), trial (number).
///
/// `EpisodeStart::text` is empty, for a trial drawn from the seed, or `trial N of seed S`: that trial as the
/// program plays it, whatever the split. Without a seed it is the program's default.
class DrillEnvironment final : public EpisodeSource {
 public:
  /// Errors: kUsage for settings out of range and for drills without trials; those of teams and models.
  static Result<std::unique_ptr<DrillEnvironment>> create(const DrillSettings& settings);

  ~DrillEnvironment() override;

  const EpisodeShape& shape() const override { return shape_; }
  Result<void> begin(const EpisodeStart& start, const EpisodeView& out) override;
  Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out) override;

  Result<void> record(const std::string& file) override;
  Result<Canvas> picture(int width) override;

  const DrillSettings& settings() const { return settings_; }
  /// The trial that is played; null before the first.
  const DrillTrialRun* trial() const { return trial_.get(); }
  /// Number of the agent's robot in that trial.
  int robot() const { return robot_; }

 private:
  explicit DrillEnvironment(const DrillSettings& settings);
  Result<DrillTrialNumber> numberOf(const EpisodeStart& start) const;
  void seat(const DrillStart& start);
  Result<void> leave();
  Result<void> startRecording();
  void settle();
  void command(std::span<const float> action);
  void tell(const EpisodeView& out) const;
  void reward(double seconds, const DrillProgressNow& before, const EpisodeView& out);
  EpisodeEnd ending() const;

  DrillSettings settings_;
  EpisodeShape shape_;
  NavigatorChoice navigator_;
  std::shared_ptr<AgentSlot> slot_ = std::make_shared<AgentSlot>();
  DrillOptions options_;
  DrillRun run_;
  MatchConfig base_;
  RobotPreset models_;  ///< before an episode draws some of their numbers
  std::unique_ptr<DrillTrialRun> trial_;
  std::optional<MatchRecorder> recorder_;
  std::string record_to_;  ///< file for the next episode; empty: none
  DrillTrialNumber number_;
  int robot_ = 0;
  bool paid_ = false;  ///< the success has been rewarded
  DrillProgressNow progress_;
  std::array<double, 3> last_action_{};
  double effort_ = 0.0;  ///< change of the action in this step
};

/// Number of the agent's robot in a start of a drill. Errors: kUsage if it has no such robot of the tested
/// team.
Result<int> agentOf(const Drill& drill, const DrillStart& start, int asked);

}  // namespace fulbito
