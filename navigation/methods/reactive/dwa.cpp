#include "navigation/methods/reactive/dwa.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"

namespace fulbito {
namespace {

constexpr double kRejected = -std::numeric_limits<double>::infinity();

double sample(double low, double high, int index, int count) {
  return count > 1 ? low + (high - low) * index / (count - 1) : (low + high) / 2;
}

}  // namespace

double Dwa::rimChange(const NavigationScene& scene, const Window& window, Twist twist) {
  return std::abs(twist.linear - window.now.linear) + std::abs(twist.angular - window.now.angular) *
                                                          scene.robot->axle_track / 2 /
                                                          scene.robot->turnShare();
}

Guidance Dwa::plan(const NavigationScene& scene) {
  const Window window = windowOf(scene);
  sweep_.look(scene, params_.margin, scene.robot->maxSpeed());
  const Twist wanted = escape_.apply(scene, choose(scene, window));
  // Speed and yaw rate change together, as in the ramp of the sweep. The yaw-first limiter would delay
  // braking.
  const double budget = scene.robot->wheel_acceleration * scene.dt;
  const double share = budget / std::max(budget, rimChange(scene, window, wanted));
  const Twist next{window.now.linear + share * (wanted.linear - window.now.linear),
                   window.now.angular + share * (wanted.angular - window.now.angular)};
  const Twist limited = limitTwist(*scene.robot, window.now, next, scene.dt);
  Guidance guidance;
  guidance.kind = GuidanceKind::kWheels;
  guidance.wheels = saturate(*scene.robot, inverseKinematics(*scene.robot, limited));
  return guidance;
}

Dwa::Window Dwa::windowOf(const NavigationScene& scene) const {
  const RobotModel& robot = *scene.robot;
  const Pose2& pose = scene.self.pose;
  const Vec2 to_goal = scene.goal.position - pose.position;
  Window window;
  window.goal = intoFrame(math::unit(pose.heading), to_goal);
  window.top_speed = robot.maxSpeed();
  window.reach = robot.wheel_acceleration * params_.window;
  const double top_turn = 2.0 * robot.maxSpeed() / robot.axle_track;
  window.now = bodyTwist(scene.self);
  window.now.linear = std::clamp(window.now.linear, -robot.maxSpeed(), robot.maxSpeed());
  window.now.angular = std::clamp(window.now.angular, -top_turn, top_turn);
  if (scene.goal.stop) {
    const double left = std::max(0.0, norm(to_goal) - scene.goal.tolerance / 2);
    window.top_speed =
        std::min(window.top_speed, stoppingSpeed(params_.braking * robot.wheel_acceleration, left));
  }
  return window;
}

Twist Dwa::choose(const NavigationScene& scene, const Window& window) const {
  const double turn_reach = 2.0 * window.reach * scene.robot->turnShare() / scene.robot->axle_track;
  const double low = std::max(0.0, window.now.linear - window.reach);
  const double high = std::clamp(window.now.linear + window.reach, low, std::max(low, window.top_speed));
  Twist best{0.0, 0.0};  // brakes straight if no sample is admissible
  double best_score = kRejected;
  for (int i = 0; i < params_.speeds; ++i) {
    for (int j = 0; j < params_.turns; ++j) {
      const Twist twist{sample(low, high, i, params_.speeds),
                        window.now.angular + sample(-turn_reach, turn_reach, j, params_.turns)};
      if (!isReachable(scene, window, twist)) continue;
      const double value = score(scene, window, twist);
      if (value > best_score) best_score = value, best = twist;
    }
  }
  return best;
}

bool Dwa::isReachable(const NavigationScene& scene, const Window& window, Twist twist) const {
  const RobotModel& robot = *scene.robot;
  const double half_track = robot.axle_track / 2, slack = 1e-9;
  const double rim = twist.linear + std::abs(twist.angular) * half_track;
  // A robot that spins or slides too fast may always slow down.
  const bool calming =
      twist.linear <= std::abs(window.now.linear) && std::abs(twist.angular) <= std::abs(window.now.angular);
  const bool grips = twist.linear * std::abs(twist.angular) <= params_.grip * robot.lateral_grip;
  return rimChange(scene, window, twist) <= window.reach + slack &&
         (calming || (rim <= robot.maxSpeed() + slack && grips));
}

double Dwa::score(const NavigationScene& scene, const Window& window, Twist twist) const {
  const Twist mean{(window.now.linear + twist.linear) / 2, (window.now.angular + twist.angular) / 2};
  const double acceleration = scene.robot->wheel_acceleration;
  const RampedArc arc{mean, rimChange(scene, window, twist) / acceleration, twist};
  const double free_time = sweep_.freeTime(arc), free_arc = arc.lengthAt(free_time);
  const double stopping = arc.lengthAt(arc.ramp_time) + twist.linear * scene.dt +
                          twist.linear * twist.linear / (2.0 * params_.braking * acceleration);
  if (free_time < sweep_.horizon() && twist.linear > 0.0 && stopping > free_arc) return kRejected;

  const Pose2 then = arc.poseAt(std::min(params_.preview, free_time));
  // Obstacles beyond the goal do not matter.
  const double clear_range = std::max(1e-3, std::min(params_.clear_range, norm(window.goal)));
  const Vec2 left = window.goal - then.position;
  const double error = math::wrapAngle(math::angleOf(left) - then.heading);
  const double possible = scene.robot->maxSpeed() * params_.preview;
  return params_.heading * (1.0 - std::abs(error) / math::kPi) +
         params_.clearance * std::min(1.0, free_arc / clear_range) +
         params_.velocity * twist.linear / scene.robot->maxSpeed() +
         params_.progress * (norm(window.goal) - norm(left)) / possible;
}

NavigatorInfo dwaInfo() {
  using P = DwaParams;
  return describeNavigator<P, Dwa>(
      "dwa", "dynamic window: best reachable speed and yaw rate", "Fox, Burgard & Thrun 1997",
      {integer("speeds", &P::speeds, 2, 50, "samples of the forward speed"),
       integer("turns", &P::turns, 3, 101, "samples of the yaw rate"),
       number("window", &P::window, 0.01, 1.0, "s", "length of the window, as time of wheel acceleration"),
       number("preview", &P::preview, 0.05, 2.0, "s", "time after which heading and progress are evaluated"),
       number("margin", &P::margin, -0.02, 0.1, "m", "distance kept from the circumscribed circle"),
       number("clear_range", &P::clear_range, 0.01, 5.0, "m", "free arc that counts as fully clear"),
       number("braking", &P::braking, 0.1, 1.0, "", "share of the wheel acceleration for stopping"),
       number("grip", &P::grip, 0.1, 1.0, "", "share of the lateral grip for bends"),
       number("heading", &P::heading, 0.0, 10.0, "", "weight of pointing at the goal"),
       number("clearance", &P::clearance, 0.0, 10.0, "", "weight of a clear arc"),
       number("velocity", &P::velocity, 0.0, 10.0, "", "weight of speed"),
       number("progress", &P::progress, 0.0, 10.0, "", "weight of progress to the goal")},
      true);
}

}  // namespace fulbito
