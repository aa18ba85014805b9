#include "experiments/localization/random_rooms.hpp"

#include <cmath>

#include "experiments/localization/first_fix.hpp"

namespace fulbito::localization {
namespace {

constexpr double kSmallest = 2.2, kLargest = 3.6;  // [m]
constexpr double kColdest = 5.0, kWarmest = 35.0;  // [degrees]

CleaningTask taskIn(const Room& room, const SensorSpread& spread, std::uint64_t seed, std::uint64_t index,
                    Rng& random) {
  CleaningTask task;
  task.field = plainRoom(room);
  task.rover = withErrors(cleaningRobot(), spread, random);
  task.spread = spread;
  const double margin = task.rover.margin;
  task.start.position = {random.uniform(margin, room.x - margin), random.uniform(margin, room.y - margin)};
  task.start.heading = random.uniform(-math::kPi, math::kPi);
  task.celsius = random.uniform(kColdest, kWarmest);
  task.seed = seed;
  task.index = index;
  return task;
}

}  // namespace

FieldGeometry plainRoom(const Room& room) {
  FieldGeometry field;
  field.name = "room";
  field.length = room.x;
  field.width = room.y;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  field.goal_area_width = field.goal_area_depth = field.goal_area_arc_width = field.goal_area_arc_depth = 0.0;
  field.centre_circle_radius = field.penalty_mark = 0.0;
  field.free_ball_mark = {};
  return field;
}

RandomRooms randomRooms(std::size_t count, std::uint64_t seed, const SensorSpread& spread) {
  RandomRooms rooms;
  const Body body = bodyOf(cleaningRobot());
  const double sigma = std::sqrt(2.0) * meanSigma(spread.range_noise);
  for (std::uint64_t index = 0; rooms.tasks.size() < count; ++index) {
    Rng random(seed, Stream::kRoom, index);
    const Room room{random.uniform(kSmallest, kLargest), random.uniform(kSmallest, kLargest)};
    if (auto clear = checkUnambiguous(room, body, sigma); !clear) {
      rooms.refusals.push_back(clear.error().message);
      continue;
    }
    rooms.tasks.push_back(taskIn(room, spread, seed, index, random));
  }
  return rooms;
}

}  // namespace fulbito::localization
