#pragma once

#include <span>
#include <vector>

#include "navigation/obstacles/echo_circle.hpp"
#include "navigation/obstacles/sector_scan.hpp"

namespace fulbito {

/// Circles fitted to the echoes of bodies near a robot. Each reading goes to the circle that it fits best. A
/// circle lives while it is heard about as often as it should be.
class EchoCircles {
 public:
  struct Settings {
    double noise = 0.005;    ///< [m] standard deviation of a range
    double gate = 3.0;       ///< standard deviations up to which a range belongs to a circle
    double apart = 0.03;     ///< [m] places nearer to a circle's surface belong to it
    double trusted = 0.004;  ///< [m] standard deviation up to which a surface counts as known
    double memory = 4.0;     ///< [s] circles that were not heard in this time are forgotten
    double drift = 0.003;    ///< [m] standard deviation of a body's motion in 1 s
  };
  /// One circle and its record.
  struct Tracked {
    EchoCircle circle;
    double credit;  ///< rises with every echo, falls with every one that is missing
    Tick heard;     ///< when it was last heard
    int name;       ///< no two circles since `reset` have the same
  };

  explicit EchoCircles(const Settings& settings);
  /// Forgets everything.
  void reset();
  /// Takes in the scene's readings of one tick.
  void update(const NavigationScene& scene);
  /// Starts a circle, unless one is near `start.surface` or there are too many.
  void start(const EchoCircleStart& start, Tick tick);

  /// The circle whose surface is nearest to `place` [m, world frame], at most `apart` off; null without one.
  const Tracked* at(Vec2 place) const;
  /// The circle of that name; null if it is gone.
  const Tracked* named(int name) const;
  /// Whether `place` [m, world frame] is in a circle or up to `slack` [m] outside of it, where its surface is
  /// known.
  bool explains(Vec2 place, double slack) const;
  /// Adds the known surfaces to what the sectors about `pose` show.
  void scan(const SectorCircle& sectors, const Pose2& pose, std::span<SectorHit> hits);

 private:
  struct Heard;
  void takeIn(const Heard& heard, Tick tick);
  void dropTwins(Vec2 robot);

  Settings settings_;
  std::vector<Tracked> circles_;
  std::vector<SectorHit> own_;  ///< what one circle shows
  int names_ = 0;
};

}  // namespace fulbito
