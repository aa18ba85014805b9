#include "experiments/papers/capture/estimator_study.hpp"

#include <array>
#include <cmath>

#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/random/streams.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr std::array<SightingNoise, 3> kLevels{
    {{0.01, 0.25 * kDegree}, {0.02, 0.5 * kDegree}, {0.05, 1.0 * kDegree}}};

/// A method to estimate the motion.
struct Method {
  const char* name;
  int sightings;
  double window;  // [s] from the first sighting to the last
  bool triangle;  // whether the heading is that of the triangle
};
constexpr std::array<Method, 5> kMethods{{{"two sightings", 2, 1.0, false},
                                          {"two sightings, triangle", 2, 1.0, true},
                                          {"least squares", 5, 1.0, false},
                                          {"least squares", 10, 1.0, false},
                                          {"least squares", 40, 4.0, false}}};

std::vector<Sighting> look(const Method& method, const SightingNoise& noise, Rng& rng) {
  std::vector<Sighting> sightings;
  for (int i = 0; i < method.sightings; ++i) {
    const double time = -method.window + method.window * i / (method.sightings - 1);
    const Vec2 to = fig18Object().at(time) - fig18Robot().position;
    sightings.push_back({time, fig18Robot().position, math::angleOf(to) + rng.normal(0.0, noise.bearing),
                         norm(to) + rng.normal(0.0, noise.range)});
  }
  return sightings;
}

EstimatorRow studied(const Method& method, const SightingNoise& noise, std::uint64_t seed,
                     std::uint64_t index, int draws) {
  EstimatorRow row{noise, method.name, method.sightings, 0.0, 0.0, 0.0};
  Rng rng(seed, kSightingStream, index);
  for (int i = 0; i < draws; ++i) {
    const std::vector<Sighting> sightings = look(method, noise, rng);
    const ObjectMotion found =
        method.sightings == 2 ? fromTwo(sightings[0], sightings[1]) : fitMotion(sightings, noise);
    const double heading =
        method.triangle ? headingByTriangle(sightings[0], sightings[1]) : math::angleOf(found.velocity);
    const double turned = math::wrapAngle(heading - math::angleOf(fig18Object().velocity));
    const double faster = norm(found.velocity) - norm(fig18Object().velocity);
    row.position += squaredNorm(found.at(0.0) - fig18Object().at(0.0)) / draws;
    row.speed += faster * faster / draws;
    row.heading += turned * turned / draws;
  }
  row.position = std::sqrt(row.position), row.speed = std::sqrt(row.speed),
  row.heading = std::sqrt(row.heading);
  return row;
}

}  // namespace

std::vector<EstimatorRow> studyEstimators(std::uint64_t seed, int draws) {
  // These indices are far above those of captures, which use the same stream.
  std::uint64_t index = 1'000'000;
  std::vector<EstimatorRow> rows;
  for (const SightingNoise& noise : kLevels) {
    for (const Method& method : kMethods) rows.push_back(studied(method, noise, seed, index++, draws));
  }
  return rows;
}

}  // namespace fulbito::capture
