#pragma once

#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// A drive in two arcs: `ramp` for the first `ramp_time` [s], then `cruise`. The ramp stands for an even
/// change between two twists, which on average is their mean.
struct RampedArc {
  Twist ramp;
  double ramp_time = 0.0;
  Twist cruise;

  /// Pose after `time` [s] of a robot that starts at the origin along x.
  Pose2 poseAt(double time) const;
  /// Driven distance [m] after `time` [s].
  double lengthAt(double time) const;
};

/// Measures how long a robot can drive an arc before it meets something.
///
/// The robot is a disc of its circumscribed circle plus a margin. Walls are those of the playing rectangle
/// with its corner triangles, and obstacles keep their velocity. The arc is divided into chords of equal
/// time; within a chord the contact is exact. An obstacle or wall nearer than the margin is shrunk to the
/// present distance, so that the robot may drive away from it but not closer.
class ArcSweep {
 public:
  /// Greatest time [s] of the search, and the number of chords in it.
  explicit ArcSweep(double horizon = 1.0, int chords = 20);
  /// Stores the obstacles and walls that a robot can meet within the horizon at up to `top_speed` [m/s].
  void look(const NavigationScene& scene, double margin, double top_speed);
  /// Time [s] until the first contact of a robot that starts to drive `arc` now, or the horizon if there is
  /// none. The ramp is rounded to whole chords.
  double freeTime(const RampedArc& arc) const;
  double horizon() const { return horizon_; }

 private:
  struct Disc {
    Vec2 centre;    // [m] at the start, in the robot's frame
    Vec2 velocity;  // [m/s] of the obstacle, in the robot's frame
    double radius;  // [m] inflated
  };
  struct Wall {
    Vec2 outward;
    double room;  // [m] distance that the centre may move along `outward`
  };
  void addDisc(Vec2 centre, Vec2 velocity, double radius, double top_speed);
  void addWalls(const FieldGeometry& field, const Pose2& pose, double radius, double top_speed);
  double contactOnChord(Vec2 from, Vec2 move, int chord) const;

  double horizon_;
  int chords_;
  std::vector<Disc> discs_;
  std::vector<Wall> walls_;
};

/// Pose after `time` [s] of a robot that starts at the origin along x and drives `twist`; exact.
Pose2 poseOnArc(Twist twist, double time);

}  // namespace fulbito
