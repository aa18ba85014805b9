#pragma once

#include "navigation/followers/wall_escape.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/obstacles/arc_sweep.hpp"

namespace fulbito {

/// Parameters of the dynamic window approach. Preview and weights are the best of a grid search (54 points;
/// time, length and failures at 0.6, 1.0 and 2.6 m/s) on 25 corner layouts that are not used to rate methods;
/// bench/surveys/dwa_survey.cpp prints it. The progress weight sets the scale.
struct DwaParams {
  int speeds = 9;            ///< samples of the forward speed
  int turns = 21;            ///< samples of the yaw rate
  double window = 0.1;       ///< [s] of wheel acceleration; sets the size of the window
  double preview = 0.3;      ///< [s] after which heading and progress are rated
  double margin = 0.005;     ///< [m] gap to the circumscribed circle
  double clear_range = 0.3;  ///< [m] length of free arc that counts as fully clear
  double braking = 0.6;      ///< share of the wheel acceleration for stopping
  double grip = 0.9;         ///< share of the lateral grip for bends
  double heading = 0.0;      ///< weight; 0 by the grid search, in favour of the progress term
  double clearance = 0.8;    ///< weight
  double velocity = 0.7;     ///< weight
  double progress = 1.0;     ///< weight
};

/// Dynamic window approach (Fox, Burgard & Thrun, IEEE RAM 4(1), 1997). It samples the speeds and yaw rates
/// that the wheels can reach within a short time. It drops those from which the robot could not stop before
/// the first obstacle on their arc. It drives the best of the rest by a weighted sum of heading to the goal,
/// clear arc, speed and progress. It plans its own speed.
///
/// Differences from the paper: obstacles move at constant velocity. Samples respect wheel saturation, the
/// lateral grip and the joint reach of the wheels. The arc starts with the change from the present twist. A
/// progress term replaces the heading term, which would hold a robot in front of an obstacle that hides the
/// goal. It is the reduction of the distance to the goal over the preview, relative to the best possible. The
/// paper's second bound on the yaw rate is left out, as v and omega fall together along the same arc. The
/// method does not aim at an arrival heading.
class Dwa final : public Navigator {
 public:
  using Params = DwaParams;
  explicit Dwa(Params params = {}) : params_(params) {}
  void reset() override { escape_.reset(); }
  Guidance plan(const NavigationScene& scene) override;

 private:
  /// Limits and goal of one tick, in the robot's frame.
  struct Window {
    Twist now;
    double reach = 0.0;      ///< [m/s] change of a wheel's rim speed within the window
    double top_speed = 0.0;  ///< [m/s] greatest speed toward the goal
    Vec2 goal;
  };
  /// Change [m/s] from now to `twist` of the rim speed of the wheel that changes more.
  static double rimChange(const NavigationScene& scene, const Window& window, Twist twist);
  Window windowOf(const NavigationScene& scene) const;
  bool isReachable(const NavigationScene& scene, const Window& window, Twist twist) const;
  double score(const NavigationScene& scene, const Window& window, Twist twist) const;
  Twist choose(const NavigationScene& scene, const Window& window) const;

  Params params_;
  ArcSweep sweep_;
  WallEscape escape_;  ///< the sweep uses a circle, which does not show that a corner presses into a wall
};

}  // namespace fulbito
