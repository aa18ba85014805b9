#pragma once

#include "engine/core/presets.hpp"

namespace fulbito::test {

/// @{ The robots and balls of engine/presets/robots, written out so that the models' tests do not depend on
/// how files are read.
inline RobotPreset vsssPreset() {
  RobotPreset preset;
  preset.robot = {.name = "vsss",
                  .mass = 0.15,
                  .wheel_radius = 0.026,
                  .axle_track = 0.0775,
                  .max_wheel_speed = 46.08,
                  .wheel_acceleration = 6.45,
                  .wheel_braking = 7.35,
                  .longitudinal_grip = 9.0,
                  .lateral_grip = 6.0,
                  .spin_slow_speed = 0.52,
                  .spin_slow_ratio = 0.9687,
                  .spin_fast_speed = 1.04,
                  .spin_fast_ratio = 1.0171};
  preset.ball = {.radius = 0.0215,
                 .mass = 0.056,
                 .roll_keep = 0.69,
                 .roll_deceleration = 0.140,
                 .wall_restitution = 0.50,
                 .wall_spin_keep = 0.306,
                 .robot_restitution = 0.04};
  return preset;
}

inline RobotPreset firasimPreset() {
  RobotPreset preset;
  preset.robot = {.name = "firasim",
                  .mass = 2.40,
                  .wheel_radius = 0.020,
                  .axle_track = 0.080,
                  .max_wheel_speed = 158.0,
                  .wheel_acceleration = 1.27,
                  .wheel_braking = 5.953,
                  .longitudinal_grip = 9.0,
                  .lateral_grip = 6.0,
                  .spin_slow_speed = 0.40,
                  .spin_slow_ratio = 0.941,
                  .spin_fast_speed = 0.80,
                  .spin_fast_ratio = 1.065};
  preset.ball = {.radius = 0.0215,
                 .mass = 0.043,
                 .roll_keep = 0.70,
                 .roll_deceleration = 0.0756,
                 .wall_restitution = 0.50,
                 .wall_spin_keep = 0.233,
                 .robot_restitution = 0.07};
  return preset;
}

inline RobotPreset paperPreset() {
  RobotPreset preset;
  preset.robot = {.name = "paper-004",
                  .mass = 0.5,
                  .wheel_radius = 0.02,
                  .axle_track = 0.068,
                  .max_wheel_speed = 130.0,
                  .wheel_acceleration = 5.0,
                  .wheel_braking = 5.0,
                  .longitudinal_grip = 10.0,
                  .lateral_grip = 6.0};
  return preset;
}
/// @}

/// @{ The physics profiles of engine/presets/physics.
inline PhysicsProfile fastPhysics() {
  return {.name = "fast", .substeps = 1, .bullet_ball = true, .max_ball_speed = 10.0};
}
inline PhysicsProfile standardPhysics() { return {.name = "standard", .substeps = 2, .max_ball_speed = 6.0}; }
inline PhysicsProfile faithfulPhysics() {
  return {.name = "faithful", .substeps = 4, .max_ball_speed = 10.0};
}
/// @}

}  // namespace fulbito::test
