#include "experiments/papers/capture/circle_fit.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace fulbito::capture {

FittedCircle fitCircle(std::span<const Vec2> points) {
  Vec2 mean;
  for (const Vec2 p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Vec2 point : points) {
    const Vec2 p = point - mean;
    const Eigen::Vector3d row(2 * p.x, 2 * p.y, 1);
    normal += row * row.transpose();
    right += row * squaredNorm(p);
  }
  const Eigen::Vector3d found = normal.ldlt().solve(right);
  const Vec2 centre{found(0), found(1)};
  return {centre + mean, std::sqrt(found(2) + squaredNorm(centre))};
}

}  // namespace fulbito::capture
