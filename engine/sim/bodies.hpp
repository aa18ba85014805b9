#pragma once

#include <cstddef>

#include "fulbito/world.hpp"

class b2Body;
class b2World;

namespace fulbito {

/// @{ Each adds one body to the engine's world, with the number that identifies it in contacts. Wall fixtures
/// are numbered in the order of `wallOutlines`.
b2Body* addWalls(b2World& world, const WorldConfig& config, std::size_t number);
b2Body* addRobot(b2World& world, const WorldConfig& config, const RobotPlacement& robot, std::size_t number);
b2Body* addBall(b2World& world, const WorldConfig& config, const BallPlacement& ball, std::size_t number);
b2Body* addObstacle(b2World& world, const WorldConfig& config, const ObstacleSpec& obstacle,
                    std::size_t number);
/// @}

}  // namespace fulbito
