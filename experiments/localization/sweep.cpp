#include "experiments/localization/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito::localization {
namespace {

constexpr double kLevel = 1.05;   // of the shortest range
constexpr double kOutlier = 4.0;  // sigmas beyond which an echo counts as one of something else
constexpr double kDegree = math::kPi / 180;
constexpr double kCoarse = 0.5 * kDegree, kFine = 0.05 * kDegree;
constexpr double kFarthestFit = 45.0 * kDegree;  // beyond, no smooth wall throws sound back

/// Echoes of a wall at distance 1 of the robot's centre, and what the sensor's reach takes off.
struct Shape {
  double stretch = 1.0;  // range over the distance of the sensor from the wall
  double reach = 0.0;    // [m] of the sensor toward the wall
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

/// The distance of the robot's centre from a wall in that direction which fits best.
double centreDistance(std::span<const SweepEcho> sweep, double perpendicular, const SweepSensor& sensor) {
  double product = 0.0, square = 0.0;
  forEchoesNear(sweep, perpendicular, [&](const SweepEcho& echo) {
    const Shape shape = shapeAt(echo.heading - perpendicular, sensor);
    product += shape.stretch * (rangeOf(echo, sensor) + shape.stretch * shape.reach);
    square += shape.stretch * shape.stretch;
  });
  return product / square;
}

/// Sum of squared residuals in sigmas. Echoes of something else cost the same wherever the wall is.
double misfit(std::span<const SweepEcho> sweep, double perpendicular, const SweepSensor& sensor) {
  const double centre = centreDistance(sweep, perpendicular, sensor);
  double sum = 0.0;
  forEchoesNear(sweep, perpendicular, [&](const SweepEcho& echo) {
    const Shape shape = shapeAt(echo.heading - perpendicular, sensor);
    const double off = (rangeOf(echo, sensor) - shape.stretch * (centre - shape.reach)) / sensor.noise;
    sum += std::min(off * off, kOutlier * kOutlier);
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
  const double coarse = bestOf(sweep, guess, kCoarse, 40, sensor);  // within 20 degrees
  return bestOf(sweep, coarse, kFine, 10, sensor);
}

}  // namespace fulbito::localization
