#pragma once

#include <optional>
#include <string>

#include "fulbito/match.hpp"

namespace fulbito {

/// Lets the user drag the ball and robots of a live match: grab, drag, drop. The match then continues in a
/// new play (`Match::replace`). A body dragged onto an occupied place stays at the last free one.
class MatchEditor {
 public:
  /// Keeps a reference to `match`.
  explicit MatchEditor(Match& match) : match_(&match) {}

  /// Grabs the body at a place [m]: the ball or a robot to move it, or a robot to turn it. Returns false if
  /// there is none, or the match is over.
  bool grab(Vec2 place, bool turn);
  bool holding() const { return held_.has_value(); }
  /// Moves the grabbed body to the place, or turns its front toward it.
  void drag(Vec2 place);
  /// Drops the body. Returns whether the match has changed.
  bool drop();
  /// Drops the body without changing the match.
  void release() { held_.reset(); }
  /// Turns the robot at a place by an angle [rad]. Returns whether the match has changed.
  bool turn(Vec2 place, double angle);

  /// The placement during a drag.
  const Placement& placement() const { return placement_; }
  /// The reason why the last drag was not possible; empty if it was.
  const std::string& flaw() const { return flaw_; }

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
  std::string flaw_;
};

}  // namespace fulbito
