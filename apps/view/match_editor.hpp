// Private header of apps/view: not installed.
#pragma once

#include <optional>
#include <string>

#include "match/play/match.hpp"

namespace fulbito {

/// Moves ball and robots of a match that is being played, by hand: take hold, drag, let go. The match goes on
/// from there in a play of its own (`Match::replace`). Nothing can be put where it has no room: it stays at
/// the last place that was free.
class MatchEditor {
 public:
  /// Refers to `match`.
  explicit MatchEditor(Match& match) : match_(&match) {}

  /// Takes hold of what is at a place [m]: of the ball or a robot to move it, of a robot to turn it. False:
  /// nothing is there, or the match is over.
  bool grab(Vec2 place, bool turn);
  bool holding() const { return held_.has_value(); }
  /// Moves what is held, or turns its front, to the place.
  void drag(Vec2 place);
  /// Lets go. True: the match was changed.
  bool drop();
  /// Lets go and changes nothing.
  void release() { held_.reset(); }
  /// Turns the robot at a place by an angle [rad]. True: the match was changed.
  bool turn(Vec2 place, double angle);

  /// Where all stand while something is held.
  const Placement& placement() const { return placement_; }
  /// Why the last drag did not do as asked; empty: it did.
  const std::string& complaint() const { return complaint_; }

 private:
  struct Held {
    std::optional<RobotId> robot;  ///< empty: the ball
    bool turn = false;
    Vec2 offset;  ///< [m] from the pointer to the body's centre
    bool changed = false;
  };
  std::optional<RobotId> robotAt(Vec2 place) const;
  Pose2& poseOf(Placement& placement, RobotId id) const;
  bool tryOut(const Placement& wanted);
  bool apply();

  Match* match_;
  Placement placement_;
  std::optional<Held> held_;
  std::string complaint_;
};

}  // namespace fulbito
