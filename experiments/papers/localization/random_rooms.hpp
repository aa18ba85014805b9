#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/papers/localization/cleaning_run.hpp"

namespace fulbito::localization {

/// Rooms of the experiment, and those that were refused.
struct RandomRooms {
  std::vector<CleaningTask> tasks;
  std::vector<std::string> refusals;  ///< reasons
};

/// `count` rooms of 2.4 to 5 m whose axes echoes can tell apart, each with a pose anywhere a robot can
/// turn, 5 to 35 degrees, and sensors with errors of their own. The same for the same seed.
RandomRooms randomRooms(std::size_t count, std::uint64_t seed, const SensorSpread& spread);

/// `count` poses of the small robot on a soccer field, as above.
std::vector<CleaningTask> fieldTasks(const FieldGeometry& field, std::size_t count, std::uint64_t seed,
                                     const SensorSpread& spread);

/// The field with boards across the goals' mouths.
FieldGeometry withoutGoals(FieldGeometry field);

/// A room without goals and corners.
FieldGeometry plainRoom(const Room& room);

}  // namespace fulbito::localization
