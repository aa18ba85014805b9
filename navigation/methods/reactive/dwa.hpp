#pragma once

#include "navigation/followers/wall_escape.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/obstacles/arc_sweep.hpp"

namespace fulbito {

/// Settings of the dynamic window approach. Preview and weights are the best of a grid search (54 points;
/// time, length and failures at 0.6, 1.0 and 2.6 m/s) on 25 corner layouts apart from those that methods are
/// judged on: bench/surveys/dwa_survey.cpp prints it. The progress weight sets the
/// scale.
struct DwaParams {
  int speeds = 9;            ///< samples of the forward speed
  int turns = 21;            ///< samples of the yaw rate
  double window = 0.1;       ///< [s] of wheel acceleration that the window spans
  double preview = 0.3;      ///< [s] after which heading and progress are judged
  double margin = 0.005;     ///< [m] kept beside the circumscribed circle
  double clear_range = 0.3;  ///< [m] of free arc that count as fully clear
  double braking = 0.6;      ///< share of the wheel acceleration that stopping relies on
  double grip = 0.9;         ///< share of the lateral grip that bends may take
  double heading = 0.0;      ///< weight; the grid search gives it up for the progress term
  double clearance = 0.8;    ///< weight
  double velocity = 0.7;     ///< weight
  double progress = 1.0;     ///< weight
};

/// Dynamic window approach (Fox, Burgard & Thrun, IEEE RAM 4(1), 1997): samples the speeds and yaw rates that
/// the wheels can reach within a short time, drops those from which the robot could not stop before the first
/// obstacle on their arc, and drives the best of the rest by a weighted sum of heading to the goal, clear
/// arc, speed and progress. Plans its own speed.
///
/// Beyond the paper: obstacles move on at constant velocity; samples must respect wheel saturation, the
/// lateral grip and the wheels' joint reach; the arc starts with the change from the present twist; and there
/// is a progress term (gain of distance to the goal over the preview, as a share of the best possible), as
/// the heading term holds a robot in front of an obstacle that hides the goal: the grid search gives it
/// weight 0. The paper's second admissibility bound (on the yaw rate) is left out, as v and omega fall
/// together along the same arc. An arrival heading is not aimed at.
class Dwa final : public Navigator {
 public:
  using Params = DwaParams;
  explicit Dwa(Params params = {}) : params_(params) {}
  void reset() override { escape_.reset(); }
  Guidance plan(const NavigationScene& scene) override;

 private:
  /// One tick's limits and goal, robot frame.
  struct Window {
    Twist now;
    double reach = 0.0;      ///< [m/s] change of a wheel's rim speed within the window
    double top_speed = 0.0;  ///< [m/s] allowed toward the goal
    Vec2 goal;
  };
  /// Change [m/s] of the faster changing wheel's rim speed from now to `twist`.
  static double rimChange(const NavigationScene& scene, const Window& window, Twist twist);
  Window windowOf(const NavigationScene& scene) const;
  bool isReachable(const NavigationScene& scene, const Window& window, Twist twist) const;
  double score(const NavigationScene& scene, const Window& window, Twist twist) const;
  Twist choose(const NavigationScene& scene, const Window& window) const;

  Params params_;
  ArcSweep sweep_;
  WallEscape escape_;  ///< the sweep's circle does not see that a corner presses into a wall
};

}  // namespace fulbito
