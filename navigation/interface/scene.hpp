#pragma once

#include <optional>
#include <span>

#include "engine/core/base/values.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/robot_model.hpp"

namespace fulbito {

/// A round obstacle as a navigator sees it. Boxes are already covered by discs.
struct DiscObstacle {
  Vec2 position;
  double radius = 0.0;  ///< [m] of the obstacle itself, not inflated by the robot
  Vec2 velocity;        ///< [m/s]
};

/// The robot's goal.
struct NavigationGoal {
  Vec2 position;
  std::optional<double> heading;      ///< [rad] wanted on arrival
  double tolerance = 0.03;            ///< [m]
  double heading_tolerance = 0.1745;  ///< [rad]
  bool stop = false;                  ///< stop there; otherwise the robot may pass at speed
};

/// Everything that a navigator knows in one control tick. Views are valid during the call only.
struct NavigationScene {
  Tick tick = 0;
  double dt = 1.0 / 60.0;  ///< [s] control period
  RobotState self;
  NavigationGoal goal;
  std::span<const DiscObstacle> obstacles;
  const FieldGeometry* field = nullptr;  ///< never null
  const RobotModel* robot = nullptr;     ///< never null; its max_wheel_speed is the speed limit of this run
};

}  // namespace fulbito
