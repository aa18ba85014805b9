#pragma once

#include <string>

#include "fulbito/strategy.hpp"

/// Values of the conversation as JSON at the end of a buffer.
namespace fulbito::lines {

void append(std::string& out, const Observation& observation);
/// null if the event has no clause.
void append(std::string& out, const GameEvent& event);
/// Poses of the first `team_size` robots; null for a robot without one.
void append(std::string& out, const TeamPlacement& poses, int team_size);
void append(std::string& out, const Exercise& exercise);
/// {"x":...,"y":...}
void append(std::string& out, Vec2 point);

}  // namespace fulbito::lines
