#include "navigation/obstacles/echo_circle.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

double dot3(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

EchoCircle::EchoCircle(const EchoCircleStart& start) {
  const Vec2 n = start.inward, t = perp(n), centre = start.surface + n * start.radius;
  state_ = {centre.x, centre.y, start.radius};
  const double size = start.spread * start.spread, deep = start.deep * start.deep + size,
               across = start.across * start.across;
  const double mixed = deep * n.x * n.y + across * t.x * t.y;
  error_ = {Vec3{deep * n.x * n.x + across * t.x * t.x, mixed, size * n.x},
            Vec3{mixed, deep * n.y * n.y + across * t.y * t.y, size * n.y},
            Vec3{size * n.x, size * n.y, size}};
}

EchoCircle::Vec3 EchoCircle::times(const Vec3& v) const {
  return {dot3(error_[0], v), dot3(error_[1], v), dot3(error_[2], v)};
}

double EchoCircle::surfaceDeviation(Vec2 normal) const {
  const Vec3 g{normal.x, normal.y, 1.0};
  return std::sqrt(std::max(0.0, dot3(g, times(g))));
}

void EchoCircle::loosen(double variance) { error_[0][0] += variance, error_[1][1] += variance; }

/// To second order in the error across the way, which is large while only one bearing was heard: that error
/// makes the mean range longer than the range to the mean place.
EchoCircle::Expectation EchoCircle::expect(Vec2 sonar) const {
  const Vec2 to = centre() - sonar;
  const double far = std::max(norm(to), 1e-3);
  const Vec2 way = to / far, side = perp(way);
  const Vec3 along{way.x, way.y, -1.0}, across{side.x, side.y, 0.0};
  const double bend = dot3(across, times(across)) / far;
  return {far - radius() + bend / 2, dot3(along, times(along)) + bend * bend / 2, way};
}

void EchoCircle::correct(const Expectation& expected, double range, double noise) {
  const Vec3 gain = times({expected.way.x, expected.way.y, -1.0});
  const double whole = expected.variance + noise * noise;
  for (std::size_t i = 0; i < 3; ++i) {
    state_[i] += gain[i] / whole * (range - expected.range);
    for (std::size_t j = 0; j < 3; ++j) error_[i][j] -= gain[i] * gain[j] / whole;
  }
  state_[2] = std::max(state_[2], 0.0);
}

}  // namespace fulbito
