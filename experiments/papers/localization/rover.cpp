#include "experiments/papers/localization/rover.hpp"

namespace fulbito::localization {
namespace {

SonarModel sonarsOf(const RobotModel& robot, double least, double greatest) {
  SonarModel model;
  const Body body{robot.length, robot.width};
  for (const Beam beam : kBeams) {
    SonarSpec sonar;
    const double direction = directionOf(beam);
    sonar.mount = {math::unit(direction) * reachOf(body, beam), direction};
    sonar.least = least;
    sonar.greatest = greatest;
    model.sonars.push_back(sonar);
  }
  return model;
}

}  // namespace

Rover cleaningRobot() {
  Rover rover;
  RobotModel& robot = rover.robot;
  robot.name = "cleaning robot";
  robot.length = 0.44;
  robot.width = 0.40;
  robot.mass = 12.0;
  robot.wheel_radius = 0.05;
  robot.axle_track = 0.32;
  robot.max_wheel_speed = 10.0;  // 0.5 m/s
  robot.wheel_acceleration = 0.6;
  robot.wheel_braking = 0.6;
  rover.sonar = sonarsOf(robot, 0.10, 6.0);
  rover.spacing = 0.9 * robot.width;
  return rover;
}

Rover smallRobot() {
  Rover rover;  // the model's default body
  rover.sonar = sonarsOf(rover.robot, 0.02, 2.0);
  rover.limits.speed = 0.15;
  rover.limits.look_ahead = 0.15;
  rover.margin = 0.11;
  rover.spacing = 0.9 * rover.robot.width;
  return rover;
}

Rover withErrors(Rover rover, const SensorSpread& spread, Rng& random) {
  rover.sonar.noise = spread.range_noise;
  rover.sonar.dropout = spread.dropout;
  rover.encoders.left_scale = random.normal(1.0, spread.wheel_scale);
  rover.encoders.right_scale = random.normal(1.0, spread.wheel_scale);
  rover.encoders.slip_noise = spread.wheel_slip;
  rover.gyro.bias = random.normal(0.0, spread.gyro_bias);
  rover.gyro.drift = spread.gyro_drift;
  rover.gyro.noise = spread.gyro_noise;
  rover.gyro.scale = random.normal(1.0, spread.gyro_scale);
  return rover;
}

}  // namespace fulbito::localization
