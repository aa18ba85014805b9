#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/recorder.hpp"
#include "python/environments/agent_team.hpp"
#include "python/environments/episodes.hpp"
#include "python/environments/match/compat.hpp"
#include "python/environments/match/observations.hpp"
#include "python/environments/match/painter.hpp"
#include "python/environments/match/rewards.hpp"
#include "python/environments/match/skills.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Matches in which a caller drives some robots. Ticks in which a restart holds the robots pass within a
/// step, as no action has an effect then; the observation of a step is the first one in which play is on.
class MatchEnvironment final : public EpisodeSource {
 public:
  /// Errors: as `checkTask`.
  static Result<std::unique_ptr<MatchEnvironment>> create(MatchTask task);
  ~MatchEnvironment() override;

  const EpisodeShape& shape() const override { return shape_; }
  /// `EpisodeStart::text`: a start state as `parseStartState` reads it.
  Result<void> begin(const EpisodeStart& start, const EpisodeView& out) override;
  Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out) override;
  /// Places and motion of the ball and of all robots, in the frame of blue's goal at -x: ObservationForm
  /// kAbsolute of the true state without the agent's own part.
  void state(std::span<float> out) const override;
  Result<void> record(const std::string& file) override;
  Result<Canvas> picture(int width) override;

  /// The match of the present episode; empty before the first one.
  const Match* match() const { return match_ ? &*match_ : nullptr; }

 private:
  /// Hears what the match tells: commands and fouls of a tick.
  class Ear final : public MatchObserver {
   public:
    void onTick(const MatchTick& tick) override;
    std::array<WheelSpeeds, 2 * kMaxTeamSize> wheels{};  ///< applied, in the order of the world's robots
    PerTeam<int> fouls{};                                ///< called against each team in the last tick
  };
  struct Agent {
    RobotId id;
    CompatReward compat;
    RobotSkills skills;
    Skill skill = Skill::kStay;  ///< chosen in this step
    std::vector<float> seen;     ///< the last `stack` observations, the newest first
  };

  explicit MatchEnvironment(MatchTask task);
  void seatAgents();
  Result<MatchConfig> configOf(const EpisodeStart& start) const;
  Result<void> open(const MatchConfig& config);
  Result<void> leave();
  void advanceToChoice();
  void command(std::span<const float> actions);
  void playSkills();
  int playTick(std::span<double> terms);
  void measure(PerTeam<int> goals, Side blue_side, std::span<double> terms);
  bool measureCompat(std::span<double> terms);
  void observe(const EpisodeView& out, bool first);
  void pile(std::vector<float>& seen, std::span<float> all, bool first) const;
  void tell(const EpisodeView& out) const;
  EpisodeEnd endOf(bool goal) const;

  MatchTask task_;
  EpisodeShape shape_;
  PerTeam<std::shared_ptr<AgentSlot>> slots_;
  std::vector<Agent> agents_;
  ObservationWriter writer_;
  std::vector<float> shared_;  ///< what the agents of a team see alike; reused
  std::optional<Match> match_;
  std::optional<MatchRecorder> recorder_;
  std::string record_to_;  ///< file for the next episode; empty: none
  Ear ear_;
  std::optional<MatchPainter> painter_;
  WorldState before_;  ///< of the tick being measured; its memory is reused
  Tick begun_at_ = 0;  ///< tick of the episode's first observation
  int clipped_ = 0;    ///< numbers of the last observations that were clipped
};

}  // namespace fulbito
