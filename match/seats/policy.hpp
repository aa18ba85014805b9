#pragma once

#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// The limits of one team's commands. Faults never end a match. The policy counts each fault; the first, the
/// tenth, the hundredth ... of a kind also becomes an event.
class CommandPolicy {
 public:
  /// @param navigators  number of the team's navigators
  CommandPolicy(TeamId team, const MatchInfo& info, std::size_t navigators);

  /// To call when a new play begins: there is no previous decision.
  void reset();
  /// Takes a decision. A late one leaves the previous one in force; after too many in a row the robots stop.
  /// @param stands  as of `TeamCondition`: a late one is counted, and comes into force
  void take(TeamCommand&& decision, bool late, bool stands, const GameEvent& now,
            std::vector<GameEvent>& events);
  /// Counts the failures of a team outside the program.
  void count(const TeamCondition& condition, const GameEvent& now, std::vector<GameEvent>& events);
  /// Clamps a wheel command to the limits of the motors and rounds it to the step of the physics profile.
  WheelSpeeds actuated(WheelSpeeds wanted);

  /// The decision in force.
  const TeamCommand& command() const { return command_; }
  /// The team's faults so far.
  const TeamFaults& faults() const { return faults_; }

 private:
  void clean(std::size_t number, const GameEvent& now, std::vector<GameEvent>& events);
  void keepOnField(GoTo& go_to);
  void note(std::int64_t& count, const char* clause, const GameEvent& now, std::vector<GameEvent>& events);

  TeamId team_;
  RobotModel robot_;
  Vec2 reach_;  ///< [m] largest distance of a place to drive to from the field's centre, along x and y
  double command_step_;
  std::size_t team_size_;
  std::size_t navigators_;
  int held_most_;  ///< number of late decisions in a row for which the last one stays in force
  int held_ = 0;   ///< late decisions in a row so far
  TeamCommand command_;
  TeamFaults faults_;
};

}  // namespace fulbito
