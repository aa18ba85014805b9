#pragma once

#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// A drive in two arcs: `ramp` for the first `ramp_time` [s], then `cruise`. The twist of a robot that
/// changes evenly from one to another is on average their mean, so the ramp stands for the change.
struct RampedArc {
  Twist ramp;
  double ramp_time = 0.0;
  Twist cruise;

  /// Where it takes a robot that starts at the origin along x, after `time` [s].
  Pose2 poseAt(double time) const;
  /// Way driven [m] after `time` [s].
  double lengthAt(double time) const;
};

/// How long a robot can drive an arc before it meets something.
///
/// The robot is a disc of its circumscribed circle plus a margin. Walls are those of the playing rectangle
/// with its corner triangles; obstacles go on at their velocity. The arc is walked in chords of equal time;
/// within a chord the contact is exact. An obstacle or wall that is nearer than the disc already is shrunk to
/// the room that is left, so that driving away from it is free and driving closer is not.
class ArcSweep {
 public:
  /// Farthest time [s] that is looked at, and the number of chords in it.
  explicit ArcSweep(double horizon = 1.0, int chords = 20);
  /// Takes over what can be met within the horizon at up to `top_speed` [m/s].
  void look(const NavigationScene& scene, double margin, double top_speed);
  /// Time [s] until the first contact when the robot drives `arc` from now on; the horizon if there is none.
  /// The ramp is rounded to whole chords.
  double freeTime(const RampedArc& arc) const;
  double horizon() const { return horizon_; }

 private:
  struct Disc {
    Vec2 centre;    // robot frame at the start
    Vec2 velocity;  // of the obstacle, robot frame
    double radius;  // inflated
  };
  struct Wall {
    Vec2 outward;
    double room;  // how far the centre may go along `outward`
  };
  void addDisc(Vec2 centre, Vec2 velocity, double radius, double top_speed);
  void addWalls(const FieldGeometry& field, const Pose2& pose, double radius, double top_speed);
  double contactOnChord(Vec2 from, Vec2 move, int chord) const;

  double horizon_;
  int chords_;
  std::vector<Disc> discs_;
  std::vector<Wall> walls_;
};

/// Where `twist` takes a robot that starts at the origin along x, after `time` [s]: exact arc.
Pose2 poseOnArc(Twist twist, double time);

}  // namespace fulbito
