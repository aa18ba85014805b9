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
      scorer;             ///< the last robot to touch the ball: of `team`, or for an own goal of the other
  bool own_goal = false;  ///< off a robot of the conceding team, and not a shot on goal before
  PerTeam<int> score{};   ///< after it
};

/// Statistics of one robot during play.
struct RobotStatistics {
  Tick ticks = 0;         ///< on the field
  double distance = 0.0;  ///< [m] path length of its centre
  int touches = 0;        ///< begun contacts with the ball
  int shots = 0;
  int goals = 0;
};

/// Statistics of one team during play.
struct TeamStatistics {
  Tick possession = 0;  ///< ticks with the ball, see `kPossessionLead`
  int shots = 0;
  int shots_on_goal = 0;
  int own_goals = 0;             ///< scored against itself
  int goals_after_foul = 0;      ///< scored within `kFoulPaysWithin` of play after a foul of its own
  int wall_contacts = 0;         ///< begun contacts of its robots with walls
  int mate_contacts = 0;         ///< begun contacts between its own robots
  std::array<Tick, 3> thirds{};  ///< ticks of the ball in the own, middle and opponents' third
  std::array<RobotStatistics, kMaxTeamSize> robots{};

  double distance() const;
  int touches() const;
};

/// The number of calls by one rule.
struct CallCount {
  std::string_view clause;  ///< static lifetime
  PerTeam<int> against{};   ///< for a goal: scored by
  int neither = 0;          ///< calls against no team, such as the end of a half
  PerTeam<int> paid{};      ///< goals of the fouling team within `kFoulPaysWithin` of this foul, its last
};

/// A team gains possession when its nearest robot is this much nearer [m] to the ball than the other team's,
/// and keeps it until the reverse holds. So possession does not flicker while both press on the ball.
inline constexpr double kPossessionLead = 0.02;

/// @{ A shot: the ball was last touched by the attacking team and is faster than `kShotSpeed`. At its present
/// velocity it would cross the goal line within `kShotHorizon`, between the posts or at most `kShotNearMiss`
/// beside one. The shot is on goal if at any moment the whole ball would pass between the posts; a goal
/// always is, unless it is an own goal. A shot ends when this has not held for `kShotPause`, or when play
/// stops.
inline constexpr double kShotSpeed = 0.4;      ///< [m/s]
inline constexpr double kShotHorizon = 1.0;    ///< [s]
inline constexpr double kShotNearMiss = 0.10;  ///< [m] next to a post
inline constexpr double kShotPause = 0.25;     ///< [s]
/// @}

/// Statistics of a match. Only ticks of play count, except in `goals`, `restarts` and `calls`.
struct MatchStatistics {
  double dt = 0.0;  ///< [s] length of a tick
  Tick play_ticks = 0;
  Tick waiting_ticks = 0;  ///< ticks before a restart's signal
  int team_size = 0;
  PerTeam<TeamStatistics> teams;
  std::vector<GoalRecord> goals;
  /// Restarts by `RestartKind` and by the team that took them.
  std::array<PerTeam<int>, 6> restarts{};
  std::vector<CallCount> calls;  ///< in the order of their first occurrence
  int opponent_contacts = 0;     ///< begun contacts between robots of the two teams
  double ball_x_sum = 0.0;       ///< [m] summed over ticks; +: toward yellow's goal

  /// Share of play time, 0 ... 1, with possession. Both teams' shares add up to 1, or are 0 if neither had
  /// it.
  double possession(TeamId team) const;
  /// Share of play time of the ball in the team's own (0), the middle (1) and the opponents' third (2).
  double third(TeamId team, std::size_t which) const;
  /// [m] Mean of the ball's x, in the team's frame: positive is the opponents' half.
  double meanBallX(TeamId team) const;
  /// The number of restarts of one kind.
  int restartCount(RestartKind kind) const;
};

/// Computes the statistics of the observed match. Allocates only at goals and at the first call of a rule.
class StatisticsObserver : public MatchObserver {
 public:
  const MatchStatistics& statistics() const { return s_; }

  void matchBegins(const MatchConfig& config) override;
  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;

 private:
  /// A shot in progress.
  struct Shot {
    RobotId shooter;
    bool on_goal = false;
    Tick last = 0;  ///< tick at which it was last seen
  };
  /// The ball heads at a goal, or close to a post.
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
  std::array<Vec2, 2 * kMaxTeamSize> places_{};  ///< of the robots, one tick ago
  std::optional<TeamId> holder_;
  std::optional<RobotId> last_touch_;
  PerTeam<std::optional<RobotId>> team_touch_;  ///< last touch by each team in this play
  std::optional<Shot> shot_;
  FoulGoalFinder foul_goals_;
};

}  // namespace fulbito
