#include "experiments/papers/capture/sightings.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "fulbito/models.hpp"

namespace fulbito::capture {
namespace {

constexpr double kLeastDeviation = 1e-4;  // [m] gives a perfect camera a finite weight

/// Inverse covariance of a place in the world frame.
Eigen::Matrix2d weightOf(const Sighting& sighting, const SightingNoise& noise) {
  const Vec2 along = math::unit(sighting.bearing);
  const double radial = std::max(noise.range, kLeastDeviation);
  const double across = std::max(noise.bearing * sighting.range, kLeastDeviation);
  Eigen::Matrix2d axes;
  axes << along.x, -along.y, along.y, along.x;
  return axes * Eigen::Vector2d(1 / (radial * radial), 1 / (across * across)).asDiagonal() * axes.transpose();
}

}  // namespace

Vec2 placeOf(const Sighting& sighting) {
  return sighting.from + math::unit(sighting.bearing) * sighting.range;
}

ObjectMotion fromTwo(const Sighting& first, const Sighting& second) {
  const Vec2 b = placeOf(first), c = placeOf(second);
  return {c, (c - b) / (second.time - first.time), second.time};
}

SightingTriangle triangleOf(const Sighting& first, const Sighting& second) {
  const double l1 = first.range, l2 = second.range;
  SightingTriangle triangle;
  triangle.theta3 = std::abs(math::wrapAngle(second.bearing - first.bearing));
  const double square = l1 * l1 + l2 * l2 - 2 * l1 * l2 * math::cos(triangle.theta3);
  triangle.l3 = std::sqrt(std::max(square, 0.0));
  if (l1 * triangle.l3 == 0.0) return triangle;
  const double cosine = (l1 * l1 + square - l2 * l2) / (2 * l1 * triangle.l3);
  triangle.theta2 = math::acos(std::clamp(cosine, -1.0, 1.0));
  return triangle;
}

double headingByTriangle(const Sighting& first, const Sighting& second) {
  const SightingTriangle triangle = triangleOf(first, second);
  const double sense = math::wrapAngle(second.bearing - first.bearing) <= 0.0 ? 1.0 : -1.0;
  return math::wrapAngle(second.bearing + sense * (triangle.theta2 + triangle.theta3 - math::kPi));
}

ObjectMotion fitMotion(std::span<const Sighting> sightings, const SightingNoise& noise) {
  const double last = sightings.back().time;
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d seen = Eigen::Vector4d::Zero();
  for (const Sighting& sighting : sightings) {
    Eigen::Matrix<double, 2, 4> model;
    const double t = sighting.time - last;
    model << 1, 0, t, 0, 0, 1, 0, t;
    const Eigen::Matrix2d weight = weightOf(sighting, noise);
    const Vec2 place = placeOf(sighting);
    information += model.transpose() * weight * model;
    seen += model.transpose() * weight * Eigen::Vector2d(place.x, place.y);
  }
  const Eigen::Vector4d found = information.ldlt().solve(seen);
  return {{found(0), found(1)}, {found(2), found(3)}, last};
}

}  // namespace fulbito::capture
