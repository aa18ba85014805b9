#pragma once

#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// What one team may command: never a reason to end a match. Every fault is counted; the first, the tenth,
/// the hundredth ... of a kind also becomes an event.
class CommandPolicy {
 public:
  CommandPolicy(TeamId team, const MatchInfo& info, std::size_t navigators);

  /// Play begins anew: there is no decision before.
  void reset();
  /// Takes a decision. One that came too late leaves the one before in force; after too many in a row the
  /// robots stand.
  void take(TeamCommand&& decision, bool late, const GameEvent& now, std::vector<GameEvent>& events);
  /// Cuts a wheel command to what the motors can do and rounds it as the physics profile says.
  WheelSpeeds actuated(WheelSpeeds wanted);

  /// The decision to be carried out.
  const TeamCommand& command() const { return command_; }
  const TeamFaults& faults() const { return faults_; }

 private:
  void clean(std::size_t number, const GameEvent& now, std::vector<GameEvent>& events);
  void keepOnField(GoTo& go_to);
  void note(std::int64_t& count, const char* clause, const GameEvent& now, std::vector<GameEvent>& events);

  TeamId team_;
  RobotModel robot_;
  Vec2 reach_;  ///< [m] a place to drive to may be this far from the centre
  double command_step_;
  std::size_t team_size_;
  std::size_t navigators_;
  int held_most_;  ///< late decisions in a row for which the last one holds
  int held_ = 0;   ///< late decisions in a row so far
  TeamCommand command_;
  TeamFaults faults_;
};

}  // namespace fulbito
