#include "navigation/methods/paths/bezier_curve.hpp"

#include <algorithm>

#include "engine/core/base/assert.hpp"

namespace fulbito {
namespace {

using Weights = std::array<std::array<double, kBezierPoints>, kBezierDegree + 1>;

/// Bernstein polynomials of one degree at all sample parameters, from de Casteljau's recursion.
constexpr Weights bernstein(std::size_t degree) {
  Weights weights{};
  for (std::size_t s = 0; s < kBezierPoints; ++s) {
    const double t = static_cast<double>(s) / static_cast<double>(kBezierPoints - 1);
    weights[0][s] = 1.0;
    for (std::size_t n = 1; n <= degree; ++n) {
      for (std::size_t i = n; i > 0; --i) {
        weights[i][s] = (1.0 - t) * weights[i][s] + t * weights[i - 1][s];
      }
      weights[0][s] *= 1.0 - t;
    }
  }
  return weights;
}

constexpr std::array<Weights, kBezierDegree + 1> allBernstein() {
  std::array<Weights, kBezierDegree + 1> all{};
  for (std::size_t degree = 0; degree <= kBezierDegree; ++degree) all[degree] = bernstein(degree);
  return all;
}

constexpr std::array<Weights, kBezierDegree + 1> kBernstein = allBernstein();

}  // namespace

void sampleBezier(std::span<const Vec2> control, BezierSamples& out) {
  FULBITO_ASSERT(control.size() >= 2 && control.size() <= kBezierDegree + 1);
  const Weights& weights = kBernstein[control.size() - 1];
  out.fill({});
  for (std::size_t i = 0; i < control.size(); ++i) {
    for (std::size_t s = 0; s < kBezierPoints; ++s) out[s] += control[i] * weights[i][s];
  }
}

Vec2 bezierPoint(std::span<const Vec2> control, std::size_t index) {
  FULBITO_ASSERT(control.size() >= 2 && control.size() <= kBezierDegree + 1 && index < kBezierPoints);
  const Weights& weights = kBernstein[control.size() - 1];
  Vec2 point;
  for (std::size_t i = 0; i < control.size(); ++i) point += control[i] * weights[i][index];
  return point;
}

Vec2 acrossLine(Vec2 robot, Vec2 obstacle) { return perp(unitOr(obstacle - robot, {1.0, 0.0})); }

SafeEnds safeEnds(Vec2 robot, const Circle& obstacle, double alpha) {
  const Vec2 reach = acrossLine(robot, obstacle.centre) * (3.0 * obstacle.radius + alpha);
  return {obstacle.centre + reach, obstacle.centre - reach};
}

Vec2 controlPoint(Vec2 robot, Vec2 obstacle, int side, double tbp) {
  return obstacle + acrossLine(robot, obstacle) * (tbp * static_cast<double>(side));
}

bool properlyIntersect(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  const double of_a = cross(q - p, a - p), of_b = cross(q - p, b - p);
  const double of_p = cross(b - a, p - a), of_q = cross(b - a, q - a);
  return ((of_a > 0.0 && of_b < 0.0) || (of_a < 0.0 && of_b > 0.0)) &&
         ((of_p > 0.0 && of_q < 0.0) || (of_p < 0.0 && of_q > 0.0));
}

void selectObstacles(Vec2 robot, Vec2 goal, std::span<const Circle> obstacles, double alpha,
                     std::vector<std::size_t>& out) {
  out.clear();
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const SafeEnds ends = safeEnds(robot, obstacles[i], alpha);
    if (properlyIntersect(robot, goal, ends.a, ends.b)) out.push_back(i);
  }
  sortAlongLine(robot, goal, obstacles, out);
}

void sortAlongLine(Vec2 robot, Vec2 goal, std::span<const Circle> obstacles,
                   std::vector<std::size_t>& indices) {
  const Vec2 line = goal - robot;
  std::sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
    const double of_a = dot(obstacles[a].centre - robot, line), of_b = dot(obstacles[b].centre - robot, line);
    return of_a != of_b ? of_a < of_b : a < b;
  });
}

}  // namespace fulbito
