// Statistics and events of a match, and its report as text or JSON.
// Component `match`.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "fulbito/match.hpp"

namespace fulbito {

/// One goal of a match.
struct GoalRecord {
  double seconds = 0.0;         ///< [s] of the match, stoppages included
  int period = 1;               ///< as `GameEvent::period`
  double play_time = 0.0;       ///< [s] play time in the period
  TeamId team = TeamId::kBlue;  ///< the scoring team
  std::optional<RobotId>
      scorer;             ///< the last robot to touch the ball: of `team`, or of the other for an own goal
  bool own_goal = false;  ///< off a robot of the conceding team, without a shot on goal before
  PerTeam<int> score{};   ///< score after the goal
};

/// Statistics of one robot during play.
struct RobotStatistics {
  Tick ticks = 0;         ///< ticks on the field
  double distance = 0.0;  ///< [m] path length of its centre
  int touches = 0;        ///< contacts with the ball that began
  int shots = 0;          ///< see `kShotSpeed`
  int goals = 0;          ///< goals, without own goals
};

/// How a team stands and moves, as counts during play. The keeper is the robot nearest to the centre of the
/// own goal at that tick.
struct TeamPlay {
  Tick robot_ticks = 0;            ///< ticks of all its robots on the field
  Tick slow_ticks = 0;             ///< of these, slower than `kSlowSpeed`
  Tick field_ticks = 0;            ///< ticks of its robots without the keeper
  Tick field_slow_ticks = 0;       ///< of these, slower than `kSlowSpeed`
  Tick own_half = 0;               ///< ticks with the ball in its half
  Tick keeper_away = 0;            ///< of these, with its keeper beyond `kKeeperLeash`
  Tick uncovered = 0;              ///< ticks with none of its robots nearer to its goal line than the ball
  Tick field_uncovered = 0;        ///< the same without the keeper
  std::int64_t locks = 0;          ///< see `kLockSpeed`
  std::int64_t long_contacts = 0;  ///< contacts of two of its robots for more than `kLongContact`
  Tick longest_contact = 0;        ///< ticks of the longest contact of two of its robots

  /// Share of the time of all its robots that they are slow.
  double slow() const;
  /// The same without the keeper.
  double fieldSlow() const;
  /// Share of the time with the ball in its half in which the keeper is away.
  double keeperAway() const;
};

/// Statistics of one team during play.
struct TeamStatistics {
  Tick possession = 0;           ///< ticks with possession, see `kPossessionLead`
  int shots = 0;                 ///< see `kShotSpeed`
  int shots_on_goal = 0;         ///< shots between the posts
  int own_goals = 0;             ///< goals against itself
  int goals_after_foul = 0;      ///< goals within `kFoulPaysWithin` of its own foul
  int wall_contacts = 0;         ///< contacts of its robots with walls that began
  int mate_contacts = 0;         ///< contacts between its own robots that began
  TeamPlay play;                 ///< how its robots stand and move
  std::array<Tick, 3> thirds{};  ///< ticks with the ball in the own, middle and opponents' third
  std::array<RobotStatistics, kMaxTeamSize> robots{};  ///< by robot number

  /// [m] Path length of all its robots together.
  double distance() const;
  /// Contacts of all its robots with the ball that began.
  int touches() const;
};

/// The number of calls by one rule.
struct CallCount {
  std::string_view clause;  ///< static lifetime
  PerTeam<int> against{};   ///< calls against each team; for a goal: goals of each team
  int neither = 0;          ///< calls against no team, such as the end of a half
  /// goals of each team within `kFoulPaysWithin` of its last foul, if that was one of this rule
  PerTeam<int> paid{};
};

/// Lead [m] of a team's nearest robot toward the ball that gives it possession. The team keeps possession
/// until the other team has this lead. So possession does not flicker while both teams press on the ball.
inline constexpr double kPossessionLead = 0.02;

/// @{ A shot: the attacking team touched the ball last, and the ball is faster than `kShotSpeed`. At its
/// present velocity it would cross the goal line within `kShotHorizon`, at most `kShotNearMiss` outside the
/// posts. The shot is on goal if at any moment the whole ball would pass between the posts. A goal always
/// counts as one, unless it is an own goal. A shot ends when these conditions fail for `kShotPause`, or when
/// play stops.
inline constexpr double kShotSpeed = 0.4;      ///< [m/s]
inline constexpr double kShotHorizon = 1.0;    ///< [s]
inline constexpr double kShotNearMiss = 0.10;  ///< [m] next to a post
inline constexpr double kShotPause = 0.25;     ///< [s]
/// @}

inline constexpr double kWallGap = 0.05;  ///< [m] largest gap between a wall and a ball that counts as at it
/// [m] A ball is in a corner if its centre is at most this far from both the line of a side wall and the line
/// of an end wall.
inline constexpr double kCornerReach = 0.15;
inline constexpr double kSlowSpeed = 0.05;    ///< [m/s] slower robots nearly stand; turning does not count
inline constexpr double kKeeperLeash = 0.30;  ///< [m] largest distance of a keeper from its goal's centre

/// @{ Two robots of a team lock each other if they touch and both are slower than `kLockSpeed`, for more than
/// `kLockSeconds`. A contact is long after `kLongContact`. Pauses up to `kContactPause` end neither.
inline constexpr double kLockSpeed = 0.12;    ///< [m/s]
inline constexpr double kLockSeconds = 1.5;   ///< [s]
inline constexpr double kLongContact = 0.5;   ///< [s]
inline constexpr double kContactPause = 0.1;  ///< [s]
/// @}

/// Statistics of a match. Only ticks of play count, except in `goals`, `restarts` and `calls`.
struct MatchStatistics {
  double dt = 0.0;                ///< [s] length of a tick
  Tick play_ticks = 0;            ///< ticks of play
  Tick waiting_ticks = 0;         ///< ticks before a restart's signal
  int team_size = 0;              ///< robots per team
  PerTeam<TeamStatistics> teams;  ///< statistics of blue and yellow
  std::vector<GoalRecord> goals;  ///< goals in chronological order
  /// Number of restarts by `RestartKind` and taking team.
  std::array<PerTeam<int>, 6> restarts{};
  std::vector<CallCount> calls;  ///< number of calls by rule, in the order of their first occurrence
  int opponent_contacts = 0;     ///< contacts between robots of the two teams that began
  double ball_x_sum = 0.0;       ///< [m] summed over ticks; +: toward yellow's goal
  Tick wall_ticks = 0;           ///< ticks with the ball at a wall, see `kWallGap`
  Tick corner_ticks = 0;         ///< ticks with the ball in a corner, see `kCornerReach`

  /// Share of possession, 0 ... 1. Both teams' shares add up to 1, or are 0 if neither team had possession.
  double possession(TeamId team) const;
  /// Share of play time with the ball in the team's own (0), the middle (1) or the opponents' third (2).
  double third(TeamId team, std::size_t which) const;
  /// [m] Mean x of the ball in the team's frame; positive in the opponents' half.
  double meanBallX(TeamId team) const;
  /// Share of play time with none of the team's robots behind the ball.
  double uncovered(TeamId team) const;
  /// The same without the keeper.
  double fieldUncovered(TeamId team) const;
  /// Share of play time with the ball at a wall.
  double atWall() const;
  /// Share of play time with the ball in a corner.
  double inCorner() const;
  /// The number of restarts of one kind.
  int restartCount(RestartKind kind) const;
};

/// Computes the statistics of the observed match. Allocates only at goals and at the first call of a rule.
class StatisticsObserver final : public MatchObserver {
 public:
  /// Starts with empty statistics.
  StatisticsObserver();
  /// A moved-from observer can only be destroyed.
  StatisticsObserver(StatisticsObserver&&) noexcept;
  ~StatisticsObserver() override;

  /// Statistics of the match so far.
  const MatchStatistics& statistics() const;

  // As in MatchObserver.
  void onMatchStart(const MatchConfig& config) override;
  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One entry of a match's event log: a call of the referee, or a restart.
struct LoggedEvent {
  GameEvent call;                      ///< for a restart: tick, time, period, taking team and ball position
  std::optional<RestartKind> restart;  ///< the kind of restart; empty for a call
  PerTeam<int> score{};                ///< score after the event
};

/// Stores the events of the observed match, up to a limit.
class EventLog : public MatchObserver {
 public:
  /// Keeps at most `limit` events.
  explicit EventLog(std::size_t limit = 20000) : limit_(limit) {}
  /// Stored events in chronological order.
  const std::vector<LoggedEvent>& events() const { return events_; }
  /// Number of events beyond the limit.
  std::size_t leftOut() const { return left_out_; }

  // As in MatchObserver.
  void onMatchStart(const MatchConfig& config) override;
  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;
  void onAbandoned(const GameEvent& event, const RefereeState& referee) override;

 private:
  void keep(const LoggedEvent& event);

  std::size_t limit_;
  std::vector<LoggedEvent> events_;
  std::size_t left_out_ = 0;
  double dt_ = 0.0;
};

/// Writes the events of the observed match as JSON objects, one per line (docs/results-format.md). The first
/// line describes the match, the last one its result.
class EventLines : public MatchObserver {
 public:
  /// Receives each line, including its line end.
  using Sink = std::function<void(std::string_view)>;
  /// Writes all lines to `sink`.
  explicit EventLines(Sink sink) : sink_(std::move(sink)) {}

  // As in MatchObserver.
  void onMatchStart(const MatchConfig& config) override;
  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;
  void onAbandoned(const GameEvent& event, const RefereeState& referee) override;
  void onMatchEnd(const RefereeState& referee, Tick tick) override;

 private:
  Sink sink_;
  double dt_ = 0.0;
};

/// The data of a finished or stopped match, for its summary.
struct MatchReport {
  MatchConfig config;                   ///< configuration of the match
  RefereeState referee;                 ///< the referee's state at the end
  bool complete = true;                 ///< false: stopped before its end
  int edits = 0;                        ///< number of plays from a user's placement
  MatchStatistics statistics;           ///< statistics of the match
  std::vector<LoggedEvent> events;      ///< calls and restarts in chronological order
  std::size_t events_left_out = 0;      ///< number of events beyond the log's limit
  MatchFaults faults;                   ///< faults of both teams
  std::uint64_t final_hash = 0;         ///< `Match::hash` at the end
  double simulated = 0.0;               ///< [s] simulated time
  double wall = 0.0;                    ///< [s] wall time
  std::optional<MatchProfile> profile;  ///< time per stage, if measured
};

/// The report of a match in its present state.
MatchReport reportOf(const Match& match, const StatisticsObserver& statistics, const EventLog& events);

/// A summary for people: score, goals, and a table with one column per team.
std::string matchText(const MatchReport& report);
/// One JSON object (docs/results-format.md), with a line end. Measured times have keys that begin with
/// `compute_` or `wall_`, or `x_realtime`; everything else is byte-identical for the same match.
std::string matchJson(const MatchReport& report);
/// The simulation speed with at least two digits: "0.25 x real time". Empty if `wall` [s] is not positive.
std::string paceText(double simulated, double wall);
/// Shares of the wall time, with one line per stage.
std::string profileText(const MatchProfile& profile);

}  // namespace fulbito
