#pragma once

#include <string>

#include "fulbito/strategy.hpp"

namespace fulbito::lines {

/// @{ A model as an object with the keys of its configuration file, by the same schema.
void append(std::string& out, FieldGeometry field);
void append(std::string& out, RobotModel robot);
void append(std::string& out, BallModel ball);
void append(std::string& out, PhysicsProfile physics);
void append(std::string& out, Rules rules);
/// @}

}  // namespace fulbito::lines
