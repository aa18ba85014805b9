#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/match.hpp"
#include "fulbito/models.hpp"
#include "tests/second_referee/geometry.hpp"

/// What the second referee looks at: all that happened since the play began, tick by tick.
namespace fulbito::second {

/// A robot and what is known of it at one tick.
struct Player {
  RobotId id;
  Pose2 pose;
  Vec2 velocity;
  std::optional<Tick> in_goal_area;   ///< since when, of the area at its half's goal
  std::optional<Tick> in_big_area;    ///< the same
  std::optional<Tick> excused_until;  ///< it was pushed in
};

/// A foul of too many robots in an area, seen first at `since`.
struct Crowd {
  int end = -1;  ///< at which goal
  bool big = false;
  std::size_t robot = 0;  ///< the one too many
  Tick since = 0;
  Tick seen = 0;          ///< in how many ticks
  bool had_ball = false;  ///< the ball has been in that area meanwhile
};

/// How long the ball has been stuck.
struct Standstill {
  bool counting = false;
  Vec2 from;        ///< [m] where it began
  Tick ticks = 0;   ///< that count
  Tick inside = 0;  ///< of these, in a goal area
  Tick fast = 0;    ///< ticks in a row in which the ball was too fast
};

/// One tick of play.
struct Moment {
  Tick tick = 0;  ///< of the match
  std::vector<Player> players;
  std::vector<ContactEvent> contacts;  ///< robot indices count `players`
  Vec2 ball, ball_velocity;
  bool ball_in_goal_area = false;  ///< of the goal in the ball's half
  bool ball_in_big_area = false;
  PerTeam<std::optional<std::size_t>> keeper;  ///< index of `players`
  std::optional<Crowd> attack, defence;        ///< that wait for a decision
  Standstill standstill;

  int ballEnd() const { return ball.x < 0.0 ? -1 : 1; }
};

/// A play: from the signal to now, with what it is played by.
struct Play {
  const MatchConfig* match = nullptr;
  double dt = 0.0;        ///< [s]
  bool blue_left = true;  ///< blue defends the left goal
  TeamId begun_by = TeamId::kBlue;
  Tick signal = 0;              ///< tick of the match
  Vec2 mark;                    ///< [m] where the ball lay when play began
  std::vector<Moment> moments;  ///< the last is now

  const Rules& rules() const { return match->rules; }
  const RobotModel& body() const { return match->robot.robot; }
  double ballRadius() const { return match->robot.ball.radius; }
  const Moment& now() const { return moments.back(); }
  /// Whole ticks nearest to so many seconds.
  Tick ticks(double seconds) const;
  /// Whether so many seconds of play are over.
  bool older(const Moment& moment, double seconds) const { return moment.tick - signal >= ticks(seconds); }
  /// At which end the team's own goal is.
  int ownEnd(TeamId team) const { return (team == TeamId::kBlue) == blue_left ? -1 : 1; }
  TeamId defenderAt(int end) const { return ownEnd(TeamId::kBlue) == end ? TeamId::kBlue : TeamId::kYellow; }
};

/// What a referee calls.
struct Call {
  Tick tick = 0;
  std::string clause;
  std::optional<TeamId> team;
  std::optional<int> robot;
  RestartKind restart = RestartKind::kKickOff;
  std::optional<TeamId> restart_team;  ///< none: whoever
  std::optional<double> value;         ///< where the law gives one: of a kick 1 for a goal, 0 for a miss
};

}  // namespace fulbito::second
