#include "experiments/papers/transport/random_path.hpp"

#include "experiments/papers/random/streams.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito {
namespace {

constexpr double kInDegrees = math::kPi / 180.0;

double eitherSide(Rng& rng, double low, double high) {
  const double size = rng.uniform(low, high);
  return rng.below(2) == 0 ? size : -size;
}

Arc randomPart(Rng& rng, const Pose2& start) {
  if (rng.below(2) == 0) return {start, 0.0, rng.uniform(0.2, 1.5)};
  const double radius = rng.uniform(0.15, 0.6);
  const double turn = eitherSide(rng, 30.0, 240.0) * kInDegrees;
  return {start, turn < 0.0 ? -1.0 / radius : 1.0 / radius, (turn < 0.0 ? -turn : turn) * radius};
}

PartPath randomPath(Rng& rng) {
  std::vector<Arc> parts;
  Pose2 at;
  for (std::uint32_t left = 5 + rng.below(10); left > 0; --left) {
    parts.push_back(randomPart(rng, at));
    at = endOf(parts.back());
    if (rng.below(6) == 0)
      at.heading = math::wrapAngle(at.heading + eitherSide(rng, 15.0, 135.0) * kInDegrees);
  }
  return PartPath(std::move(parts));
}

}  // namespace

TransportTask randomTransport(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, kTransportStream, index);
  for (;;) {
    TransportTask task;
    task.rod = rng.uniform(0.3, 1.0);
    task.path = randomPath(rng);
    const auto ahead = rodLengthAhead(task.path, 0.0, task.rod);
    if (!ahead) continue;  // there is no place for the rod
    task.lead = *ahead;
    return task;
  }
}

}  // namespace fulbito
