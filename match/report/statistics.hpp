#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "match/series/foul_goals.hpp"

namespace fulbito {

/// One goal of a match.
struct GoalRecord {
  double seconds = 0.0;         ///< [s] of the match, stoppages included
  int period = 1;               ///< as in `GameEvent`
  double play_time = 0.0;       ///< [s] of play in the period
  TeamId team = TeamId::kBlue;  ///< who scored
  std::optional<RobotId>
      scorer;             ///< robot of the team that touched the ball last; of an own goal: its unlucky one
  bool own_goal = false;  ///< the ball came off the conceding team, and was no shot on goal before
  PerTeam<int> score{};   ///< after it
};

/// What one robot did in the ticks of play.
struct RobotStatistics {
  Tick ticks = 0;         ///< on the field
  double distance = 0.0;  ///< [m] way of its centre
  int touches = 0;        ///< contacts with the ball that began
  int shots = 0;
  int goals = 0;
};

/// What one team did in the ticks of play.
struct TeamStatistics {
  Tick possession = 0;  ///< ticks with the ball, see `kPossessionLead`
  int shots = 0;
  int shots_on_goal = 0;
  int own_goals = 0;             ///< that it scored against itself
  int goals_after_foul = 0;      ///< for it, within `kFoulPaysWithin` of play after a foul of its own
  int wall_contacts = 0;         ///< of robots with walls, that began
  int mate_contacts = 0;         ///< between its own robots, that began
  std::array<Tick, 3> thirds{};  ///< ticks of the ball in the own, middle and opponents' third
  std::array<RobotStatistics, kMaxTeamSize> robots{};

  double distance() const;
  int touches() const;
};

/// How often the referee called one rule.
struct CallCount {
  std::string_view clause;  ///< static lifetime
  PerTeam<int> against{};   ///< of a goal: for
  int neither = 0;          ///< calls against no team, such as the end of a half
  PerTeam<int> paid{};      ///< goals of the team at fault, this its last foul, within `kFoulPaysWithin`
};

/// A team gets the ball when its nearest robot is this much nearer [m] than the other's, and keeps it until
/// the other is; so the ball does not change hands when both press on it.
inline constexpr double kPossessionLead = 0.02;

/// @{ A shot: the ball, last touched by the attacking team, is faster than this and would cross the goal line
/// within this time, in a straight line at its present speed, between the posts or this close to them. It is
/// on goal when the whole ball would pass between the posts at any moment of the shot; a goal that is no own
/// goal always is. A shot is over when none of this holds for the pause, or when play stops.
inline constexpr double kShotSpeed = 0.4;      ///< [m/s]
inline constexpr double kShotHorizon = 1.0;    ///< [s]
inline constexpr double kShotNearMiss = 0.10;  ///< [m] beside a post
inline constexpr double kShotPause = 0.25;     ///< [s]
/// @}

/// What happened in a match. Only ticks of play count, but for `goals`, `restarts` and `calls`.
struct MatchStatistics {
  double dt = 0.0;  ///< [s] a tick
  Tick play_ticks = 0;
  Tick waiting_ticks = 0;  ///< restarts waiting for their signal
  int team_size = 0;
  PerTeam<TeamStatistics> teams;
  std::vector<GoalRecord> goals;
  /// Restarts by `RestartKind` and by the team that took them.
  std::array<PerTeam<int>, 6> restarts{};
  std::vector<CallCount> calls;  ///< in the order of their first
  int opponent_contacts = 0;     ///< between robots of the two teams, that began
  double ball_x_sum = 0.0;       ///< [m] summed over ticks; +: toward yellow's goal

  /// Share of play time, 0 ... 1, in which the team had the ball; both add up to 1 once anyone had it.
  double possession(TeamId team) const;
  /// Share of play time of the ball in the team's own (0), the middle (1) and the opponents' third (2).
  double third(TeamId team, std::size_t which) const;
  /// [m] Mean of the ball's x, in the team's frame: positive is the opponents' half.
  double meanBallX(TeamId team) const;
  /// Restarts of one kind.
  int restartCount(RestartKind kind) const;
};

/// Computes the statistics of the match that it watches. Allocates nothing in a tick, but at goals and at the
/// first call of a rule.
class StatisticsObserver : public MatchObserver {
 public:
  const MatchStatistics& statistics() const { return s_; }

  void matchBegins(const MatchConfig& config) override;
  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;

 private:
  /// A shot that is under way.
  struct Shot {
    RobotId shooter;
    bool on_goal = false;
    Tick last = 0;  ///< tick at which it was seen last
  };
  /// Where the ball is heading: at a goal mouth or close beside it.
  struct Aim {
    TeamId attacker = TeamId::kBlue;
    bool on_goal = false;
  };

  void countContacts(const MatchTick& tick);
  void countMoves(const MatchTick& tick);
  void countBall(const MatchTick& tick);
  void watchShot(const MatchTick& tick);
  void countCalls(std::span<const GameEvent> events, const RefereeState& referee);
  void goal(const GameEvent& event, TeamId team, const RefereeState& referee);
  void countPaid(const GameEvent& event, Tick played);
  void countGoalAsShot(const GoalRecord& goal);
  std::optional<Aim> aimOf(const BallState& ball, const RefereeState& referee) const;
  void onGoal(Shot& shot);
  RobotStatistics& of(RobotId id) { return s_.teams[indexOf(id.team)].robots[id.number]; }

  MatchStatistics s_;
  double half_length_ = 0.0;
  double post_ = 0.0;  ///< [m] half of the mouth
  double ball_radius_ = 0.0;
  Tick shot_pause_ = 0;
  bool playing_ = false;
  std::array<Vec2, 2 * kMaxTeamSize> places_{};  ///< of the robots in the tick before
  std::optional<TeamId> holder_;
  std::optional<RobotId> last_touch_;
  PerTeam<std::optional<RobotId>> team_touch_;  ///< last of each team in this play
  std::optional<Shot> shot_;
  FoulGoalFinder foul_goals_;
};

}  // namespace fulbito
