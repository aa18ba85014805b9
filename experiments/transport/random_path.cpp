#include "experiments/transport/random_path.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kInDegrees = math::kPi / 180.0;

double eitherSide(Rng& random, double low, double high) {
  const double size = random.uniform(low, high);
  return random.below(2) == 0 ? size : -size;
}

Arc randomPart(Rng& random, const Pose2& start) {
  if (random.below(2) == 0) return {start, 0.0, random.uniform(0.2, 1.5)};
  const double radius = random.uniform(0.15, 0.6);
  const double turn = eitherSide(random, 30.0, 240.0) * kInDegrees;
  return {start, turn < 0.0 ? -1.0 / radius : 1.0 / radius, (turn < 0.0 ? -turn : turn) * radius};
}

PartPath randomPath(Rng& random) {
  std::vector<Arc> parts;
  Pose2 at;
  for (std::uint32_t left = 5 + random.below(10); left > 0; --left) {
    parts.push_back(randomPart(random, at));
    at = endOf(parts.back());
    if (random.below(6) == 0)
      at.heading = math::wrapAngle(at.heading + eitherSide(random, 15.0, 135.0) * kInDegrees);
  }
  return PartPath(std::move(parts));
}

}  // namespace

TransportTask randomTransport(std::uint64_t seed, std::uint64_t index) {
  Rng random(seed, Stream::kTransport, index);
  for (;;) {
    TransportTask task;
    task.rod = random.uniform(0.3, 1.0);
    task.path = randomPath(random);
    const auto ahead = rodLengthAhead(task.path, 0.0, task.rod);
    if (!ahead) continue;  // no place for the rod at all
    task.lead = *ahead;
    return task;
  }
}

}  // namespace fulbito
