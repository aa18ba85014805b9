#include "experiments/papers/localization/estimation/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "fulbito/models.hpp"

namespace fulbito::localization {
namespace {

constexpr double kLevel = 1.05;   // relative to the shortest range
constexpr double kOutlier = 4.0;  // sigmas; an echo with a larger error counts as one from something else
constexpr double kDegree = math::kPi / 180;
constexpr double kCoarse = 0.5 * kDegree, kFine = 0.05 * kDegree;
constexpr double kFarthestFit = 45.0 * kDegree;  // smooth walls return no echo beyond this angle

/// How an echo's range follows from the distance of a wall, at one angle.
struct Shape {
  double stretch = 1.0;  // range per distance from the sensor to the wall
  double reach = 0.0;    // [m] from the robot's centre to the sensor, perpendicular to the wall
};

Shape shapeAt(double off, const SweepSensor& sensor) {
  const double beyond = std::max(0.0, std::abs(off) - sensor.cone);
  return {1.0 / math::cos(beyond), sensor.reach * math::cos(off)};
}

double rangeOf(const SweepEcho& echo, const SweepSensor& sensor) { return *echo.time * sensor.echo_speed; }

template <typename Use>
void forEchoesNear(std::span<const SweepEcho> sweep, double perpendicular, const Use& use) {
  for (const SweepEcho& echo : sweep) {
    if (echo.time && std::abs(echo.heading - perpendicular) <= kFarthestFit) use(echo);
  }
}

/// The distance [m] from the robot's centre to a wall with the given perpendicular that fits best: the median
/// over the echoes, then the mean of those near it.
double centreDistance(std::span<const SweepEcho> sweep, double perpendicular, const SweepSensor& sensor) {
  std::vector<double> said;
  forEchoesNear(sweep, perpendicular, [&](const SweepEcho& echo) {
    const Shape shape = shapeAt(echo.heading - perpendicular, sensor);
    said.push_back(rangeOf(echo, sensor) / shape.stretch + shape.reach);
  });
  if (said.empty()) return 0.0;
  const auto middle = said.begin() + static_cast<std::ptrdiff_t>(said.size() / 2);
  std::nth_element(said.begin(), middle, said.end());
  const double median = *middle;
  double sum = 0.0, count = 0.0;
  for (const double centre : said) {
    if (std::abs(centre - median) <= kOutlier * sensor.noise) sum += centre, count += 1.0;
  }
  return sum / count;
}

/// Sum of the squared residuals in sigmas. Outliers have a constant cost, which is independent of the wall.
double misfit(std::span<const SweepEcho> sweep, double perpendicular, const SweepSensor& sensor) {
  const double centre = centreDistance(sweep, perpendicular, sensor);
  double sum = 0.0;
  for (const SweepEcho& echo : sweep) sum += echo.time ? kOutlier * kOutlier : 0.0;
  forEchoesNear(sweep, perpendicular, [&](const SweepEcho& echo) {
    const Shape shape = shapeAt(echo.heading - perpendicular, sensor);
    const double off = (rangeOf(echo, sensor) - shape.stretch * (centre - shape.reach)) / sensor.noise;
    sum += std::min(off * off - kOutlier * kOutlier, 0.0);
  });
  return sum;
}

/// The best of the candidates `guess` +- `steps` times `step`.
double bestOf(std::span<const SweepEcho> sweep, double guess, double step, int steps,
              const SweepSensor& sensor) {
  double best = guess, least = std::numeric_limits<double>::infinity();
  for (int i = -steps; i <= steps; ++i) {
    const double sum = misfit(sweep, guess + i * step, sensor);
    if (sum < least) least = sum, best = guess + i * step;
  }
  return best;
}

const SweepEcho* shortest(std::span<const SweepEcho> sweep) {
  const SweepEcho* best = nullptr;
  for (const SweepEcho& echo : sweep) {
    if (echo.time && (best == nullptr || *echo.time < *best->time)) best = &echo;
  }
  return best;
}

}  // namespace

std::optional<double> shortestEcho(std::span<const SweepEcho> sweep) {
  const SweepEcho* best = shortest(sweep);
  return best == nullptr ? std::nullopt : std::optional(best->heading);
}

std::optional<double> levelCentre(std::span<const SweepEcho> sweep, const SweepSensor& sensor) {
  const SweepEcho* best = shortest(sweep);
  if (best == nullptr) return std::nullopt;
  const double least = rangeOf(*best, sensor);
  const double level = std::max(kLevel * least, least + kOutlier * sensor.noise);
  double low = best->heading, high = best->heading;
  forEchoesNear(sweep, best->heading, [&](const SweepEcho& echo) {
    if (rangeOf(echo, sensor) > level) return;
    low = std::min(low, echo.heading);
    high = std::max(high, echo.heading);
  });
  return (low + high) / 2;
}

double fittedPerpendicular(std::span<const SweepEcho> sweep, double guess, const SweepSensor& sensor) {
  const double coarse = bestOf(sweep, guess, kCoarse, 40, sensor);  // searches within 20 degrees
  return bestOf(sweep, coarse, kFine, 10, sensor);
}

}  // namespace fulbito::localization
