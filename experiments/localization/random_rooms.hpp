#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/localization/cleaning_run.hpp"

namespace fulbito::localization {

/// Rooms of the experiment, and those that were refused.
struct RandomRooms {
  std::vector<CleaningTask> tasks;
  std::vector<std::string> refusals;  ///< reasons
};

/// `count` rooms of 2.2 to 3.6 m whose axes echoes can tell apart, each with a pose anywhere a robot can
/// turn, 5 to 35 degrees, and sensors with errors of their own. The same for the same seed.
RandomRooms randomRooms(std::size_t count, std::uint64_t seed, const SensorSpread& spread);

/// A room without goals and corners.
FieldGeometry plainRoom(const Room& room);

}  // namespace fulbito::localization
