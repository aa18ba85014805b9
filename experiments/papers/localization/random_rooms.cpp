#include "experiments/papers/localization/random_rooms.hpp"

#include <cmath>

#include "experiments/papers/localization/first_fix.hpp"
#include "experiments/papers/random/streams.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {
namespace {

constexpr double kSmallest = 2.4, kLargest = 5.0;  // [m]
constexpr std::uint64_t kFieldIndex = 1'000'000;   // different from the indices of the rooms
constexpr double kColdest = 5.0, kWarmest = 35.0;  // [degrees]

/// Draws what all tasks share, in this order: errors of the sensors, pose, temperature.
CleaningTask taskIn(const FieldGeometry& field, const Rover& rover, const SensorSpread& spread, Rng& draws) {
  CleaningTask task;
  task.field = field;
  task.rover = withErrors(rover, spread, draws);
  task.spread = spread;
  const double margin = rover.margin;
  task.start.position.x = draws.uniform(margin, field.length - margin);
  task.start.position.y = draws.uniform(margin, field.width - margin);
  task.start.heading = draws.uniform(-math::kPi, math::kPi);
  task.celsius = draws.uniform(kColdest, kWarmest);
  return task;
}

void number(CleaningTask& task, std::uint64_t seed, std::uint64_t index) {
  task.seed = seed;
  task.index = index;
}

}  // namespace

FieldGeometry plainRoom(const Room& room) { return plainFloor("room", room.x, room.y); }

RandomRooms randomRooms(std::size_t count, std::uint64_t seed, const SensorSpread& spread) {
  RandomRooms rooms;
  const Rover rover = cleaningRobot();
  const double sigma = std::sqrt(2.0) * meanSigma(spread.range_noise);
  for (std::uint64_t index = 0; rooms.tasks.size() < count; ++index) {
    Rng draws(seed, kRoomStream, index);
    Room room;
    room.x = draws.uniform(kSmallest, kLargest);
    room.y = draws.uniform(kSmallest, kLargest);
    if (auto clear = checkUnambiguous(room, bodyOf(rover), sigma); !clear) {
      rooms.refusals.push_back(clear.error().message);
      continue;
    }
    rooms.tasks.push_back(taskIn(plainRoom(room), rover, spread, draws));
    number(rooms.tasks.back(), seed, index);
  }
  return rooms;
}

std::vector<CleaningTask> fieldTasks(const FieldGeometry& field, std::size_t count, std::uint64_t seed,
                                     const SensorSpread& spread) {
  std::vector<CleaningTask> tasks;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t index = kFieldIndex + i;
    Rng draws(seed, kRoomStream, index);
    tasks.push_back(taskIn(field, smallRobot(), spread, draws));
    number(tasks.back(), seed, index);
  }
  return tasks;
}

FieldGeometry withoutGoals(FieldGeometry field) {
  field.goal_width = field.goal_depth = 0.0;
  return field;
}

}  // namespace fulbito::localization
