#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/papers/localization/cleaning_run.hpp"

namespace fulbito::localization {

/// Rooms of the experiment, and the reasons of the refused ones.
struct RandomRooms {
  std::vector<CleaningTask> tasks;
  std::vector<std::string> refusals;  ///< one reason per refused room
};

/// `count` rooms of 2.4 to 5 m whose axes echoes can identify. Each has a random pose at which the robot can
/// turn, 5 to 35 degrees, and its own sensor errors. The same seed gives the same rooms.
RandomRooms randomRooms(std::size_t count, std::uint64_t seed, const SensorSpread& spread);

/// `count` poses of the small robot on a soccer field, drawn in the same way.
std::vector<CleaningTask> fieldTasks(const FieldGeometry& field, std::size_t count, std::uint64_t seed,
                                     const SensorSpread& spread);

/// The field with boards that close the goal mouths.
FieldGeometry withoutGoals(FieldGeometry field);

/// A room without goals and corners.
FieldGeometry plainRoom(const Room& room);

}  // namespace fulbito::localization
