#include "engine/sim/check_config.hpp"

#include <cmath>
#include <string>

namespace fulbito {
namespace {

// Keeps the first flaw of one part of a configuration.
class Check {
 public:
  explicit Check(std::string part) : part_(std::move(part)) {}

  Check& range(const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high)) {
      complain(name, "must be " + number(low) + " ... " + number(high) + ", not " + number(value));
    }
    return *this;
  }
  Check& finite(const char* name, Vec2 value) {
    return range(name, value.x, -kFar, kFar).range(name, value.y, -kFar, kFar);
  }
  Check& inside(const char* name, Vec2 value, const FieldGeometry& field) {
    finite(name, value);
    if (!insideField(field, value)) {
      complain(name, "(" + number(value.x) + ", " + number(value.y) + ") is outside the field");
    }
    return *this;
  }
  Check& that(bool holds, const char* name, const char* demand) {
    if (!holds) complain(name, demand);
    return *this;
  }
  Result<void> result() const {
    if (error_.empty()) return {};
    return fail(ErrorCode::kBadInput, error_);
  }

 private:
  static constexpr double kFar = 1e3;

  static std::string number(double value) {
    std::string text = std::to_string(value);
    while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
      const bool was_point = text.back() == '.';
      text.pop_back();
      if (was_point) break;
    }
    return text;
  }
  void complain(const char* name, const std::string& what) {
    if (error_.empty()) error_ = part_ + ": " + name + " " + what;
  }

  std::string part_;
  std::string error_;
};

constexpr double kMaxSpeed = 50.0;      // [m/s]
constexpr double kMaxYawRate = 1000.0;  // [rad/s]
constexpr double kMaxRate = 1e4;        // [m/s^2]

Result<void> checkField(const FieldGeometry& field) {
  Check check("field");
  check.range("length", field.length, 0.3, 20.0)
      .range("width", field.width, 0.3, 20.0)
      .range("goal_width", field.goal_width, 0.0, 20.0)
      .range("goal_depth", field.goal_depth, 0.0, 5.0)
      .range("corner", field.corner, 0.0, 10.0)
      .range("wall_thickness", field.wall_thickness, 0.005, 1.0);
  if (auto result = check.result(); !result) return result;
  return validate(field);
}

Result<void> checkPhysics(const PhysicsProfile& physics) {
  return Check("physics")
      .range("control_rate", physics.control_rate, 10, 1000)
      .range("substeps", physics.substeps, 1, 64)
      .range("velocity_iterations", physics.velocity_iterations, 1, 50)
      .range("position_iterations", physics.position_iterations, 1, 50)
      .range("restitution_threshold", physics.restitution_threshold, 0.0, 10.0)
      .range("contact_depth", physics.contact_depth, 0.0, 0.1)
      .range("wheel_command_step", physics.wheel_command_step, 0.0, 10.0)
      .that(physics.wheel_command_step == 0.0 || physics.wheel_command_step >= 1e-6, "wheel_command_step",
            "must be 0 or at least 1e-6")
      .result();
}

Result<void> checkRobot(const RobotPlacement& robot, const FieldGeometry& field, const std::string& part) {
  const RobotModel& model = robot.model;
  return Check(part)
      .inside("position", robot.pose.position, field)
      .range("heading", robot.pose.heading, -100.0, 100.0)
      .range("velocity", norm(robot.velocity), 0.0, kMaxSpeed)
      .range("angular_velocity", robot.angular_velocity, -kMaxYawRate, kMaxYawRate)
      .range("length", model.length, 0.01, 1.0)
      .range("width", model.width, 0.01, 1.0)
      .range("mass", model.mass, 1e-3, 100.0)
      .range("wheel_radius", model.wheel_radius, 1e-3, 0.5)
      .range("axle_track", model.axle_track, 5e-3, 1.0)
      .range("max_wheel_speed", model.max_wheel_speed, 0.0, 1e4)
      .range("wheel_acceleration", model.wheel_acceleration, 0.0, kMaxRate)
      .range("wheel_braking", model.wheel_braking, 0.0, kMaxRate)
      .range("yaw_acceleration", model.yaw_acceleration, 0.0, 1e5)
      .range("rolling_drag", model.rolling_drag, 0.0, kMaxRate)
      .range("longitudinal_grip", model.longitudinal_grip, 0.0, kMaxRate)
      .range("lateral_grip", model.lateral_grip, 0.0, kMaxRate)
      .range("spin_slow_speed", model.spin_slow_speed, 0.0, 100.0)
      .range("spin_fast_speed", model.spin_fast_speed, 0.0, 100.0)
      .range("spin_slow_ratio", model.spin_slow_ratio, 0.1, 10.0)
      .range("spin_fast_ratio", model.spin_fast_ratio, 0.1, 10.0)
      .range("wheel_width", model.wheel_width, 0.0, 1.0)
      .range("support_distance", model.support_distance, 0.0, 1.0)
      .range("support_sink", model.support_sink, 0.0, 0.01)
      .range("support_settling", model.support_settling, 0.0, 1.0)
      .range("mass_height", model.mass_height, 0.0, 1.0)
      .range("ground_clearance", model.ground_clearance, 0.0, 1.0)
      .range("load_shift", model.load_shift, 0.0, 1.0)
      .range("rim_mass", model.rim_mass, 0.0, 100.0)
      .range("curve_widening", model.curve_widening, 0.0, 100.0)
      .range("curve_widening_rise", model.curve_widening_rise, 0.0, 100.0)
      .range("friction", model.friction, 0.0, 10.0)
      .range("restitution", model.restitution, 0.0, 1.0)
      .result();
}

Result<void> checkBall(const BallPlacement& ball, const FieldGeometry& field, const std::string& part) {
  const BallModel& model = ball.model;
  return Check(part)
      .inside("position", ball.position, field)
      .range("velocity", norm(ball.velocity), 0.0, kMaxSpeed)
      .range("spin", norm(ball.spin), 0.0, kMaxSpeed)
      .range("radius", model.radius, 2e-3, 0.5)
      .range("mass", model.mass, 1e-3, 100.0)
      .range("roll_keep", model.roll_keep, 0.0, 1.0)
      .range("slide_deceleration", model.slide_deceleration, 0.0, kMaxRate)
      .range("roll_deceleration", model.roll_deceleration, 0.0, kMaxRate)
      .range("stop_speed", model.stop_speed, 0.0, 10.0)
      .range("wall_restitution", model.wall_restitution, 0.0, 1.0)
      .range("wall_spin_keep", model.wall_spin_keep, -1.0, 1.0)
      .range("robot_restitution", model.robot_restitution, 0.0, 1.0)
      .range("friction", model.friction, 0.0, 10.0)
      .result();
}

Result<void> checkObstacle(const ObstacleSpec& obstacle, const FieldGeometry& field,
                           const std::string& part) {
  Check check(part);
  check.range("heading", obstacle.pose.heading, -100.0, 100.0);
  if (obstacle.shape == ObstacleShape::kDisc) {
    check.range("radius", obstacle.radius, 2e-3, 2.0);
  } else {
    check.range("length", obstacle.length, 5e-3, 5.0).range("width", obstacle.width, 5e-3, 5.0);
  }
  if (obstacle.motion == ObstacleMotion::kPath) {
    check.that(obstacle.path.size() >= 2, "path", "needs at least 2 waypoints")
        .range("speed", obstacle.speed, 0.0, kMaxSpeed);
    for (Vec2 waypoint : obstacle.path) check.inside("path", waypoint, field);
  } else {
    check.inside("position", obstacle.pose.position, field);
  }
  if (obstacle.motion == ObstacleMotion::kPushable) {
    check.range("mass", obstacle.mass, 1e-3, 100.0)
        .range("floor_friction", obstacle.floor_friction, 0.0, kMaxRate);
  }
  return check.result();
}

Result<void> checkRod(const RodPlacement& rod, const WorldConfig& config, const std::string& part) {
  constexpr double kFit = 0.001;  // [m] a larger gap would make the engine jerk the robots together
  const std::size_t count = config.robots.size();
  Check check(part);
  check.that(rod.first < count, "first", "must be the index of a robot")
      .that(rod.second < count, "second", "must be the index of a robot")
      .that(rod.first != rod.second, "second", "must be another robot than first")
      .range("length", rod.length, 0.02, 20.0)
      .range("mass", rod.mass, 1e-3, 100.0);
  if (auto result = check.result(); !result) return result;
  const double apart =
      distance(config.robots[rod.first].pose.position, config.robots[rod.second].pose.position);
  return check.range("length", rod.length, apart - kFit, apart + kFit).result();
}

template <typename List, typename CheckOne>
Result<void> checkEach(const char* kind, const List& list, const FieldGeometry& field, CheckOne check_one) {
  if (list.size() > 1000) return fail(ErrorCode::kBadInput, std::string("more than 1000 ") + kind + "s");
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto result = check_one(list[i], field, std::string(kind) + " " + std::to_string(i));
    if (!result) return result;
  }
  return {};
}

}  // namespace

Result<void> checkConfig(const WorldConfig& config) {
  if (auto result = checkField(config.field); !result) return result;
  if (auto result = checkPhysics(config.physics); !result) return result;
  if (auto result = checkEach("robot", config.robots, config.field, checkRobot); !result) return result;
  if (auto result = checkEach("ball", config.balls, config.field, checkBall); !result) return result;
  if (auto result = checkEach("obstacle", config.obstacles, config.field, checkObstacle); !result)
    return result;
  for (std::size_t i = 0; i < config.rods.size(); ++i) {
    auto result = checkRod(config.rods[i], config, "rod " + std::to_string(i));
    if (!result) return result;
  }
  return {};
}

}  // namespace fulbito
