#include "experiments/papers/localization/estimation/initial_pose.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fulbito::localization {
namespace {

double timeOf(const EchoTimes& times, Beam beam) { return *times[indexOf(beam)]; }

/// Covariance of two quantities from their derivatives by the three echo distances.
double covarianceOf(const std::array<double, 3>& a, const std::array<double, 3>& b, double sigma) {
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * sigma * sigma;
}

/// Covariance of x, y and the constant from the distances to the front, one side and the other side. The
/// constant makes the sum of both sides fit the room, so x takes only half of each change if the sides are
/// equal.
std::array<double, 9> covarianceFrom(const AxisDecision& axis, double front, double side, double other,
                                     double sigma) {
  const double between = side + other;
  const std::array<double, 3> constant{0.0, -axis.echo_speed / between, -axis.echo_speed / between};
  const std::array<double, 3> across{0.0, other / between, -side / between};
  const std::array<double, 3> ahead{1.0, -front / between, -front / between};
  const bool along_y = axis.facing == Facing::kMinusY;
  const std::array rows{along_y ? across : ahead, along_y ? ahead : across, constant};
  std::array<double, 9> covariance{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) covariance[i * 3 + j] = covarianceOf(rows[i], rows[j], sigma);
  }
  return covariance;
}

/// The side whose wall contains the origin: right when facing -y, left when facing -x.
Beam originSide(Facing facing) { return facing == Facing::kMinusY ? Beam::kRight : Beam::kLeft; }

}  // namespace

Pose2 poseFacing(const AxisDecision& axis, const EchoTimes& times, const Body& body) {
  const double ahead = axis.echo_speed * timeOf(times, Beam::kFront) + body.length / 2;
  const double across = axis.echo_speed * timeOf(times, originSide(axis.facing)) + body.width / 2;
  if (axis.facing == Facing::kMinusY) return {{across, ahead}, -math::kPi / 2};
  return {{ahead, across}, -math::kPi};
}

Result<InitialPose> locate(const Room& room, const Body& body, const EchoTimes& times, double sigma) {
  for (const auto& time : times) {
    if (!time) return fail(ErrorCode::kBadInput, "a sensor has no echo of its wall");
  }
  const double side_time = timeOf(times, Beam::kRight) + timeOf(times, Beam::kLeft);
  const auto axis = decideAxis(room, body, side_time, std::sqrt(2.0) * sigma);
  if (!axis) return tl::unexpected<Error>(axis.error());
  const double front = axis->echo_speed * timeOf(times, Beam::kFront);
  const double deepest = (axis->facing == Facing::kMinusY ? room.y : room.x) - body.length;
  if (front > deepest + 4 * sigma) {
    return fail(ErrorCode::kBadInput,
                fmt::format("the wall ahead is {:.3f} m away, but the room leaves {:.3f} m", front, deepest));
  }
  const double side = axis->echo_speed * timeOf(times, originSide(axis->facing));
  const double other = axis->echo_speed * side_time - side;
  return InitialPose{*axis, poseFacing(*axis, times, body), covarianceFrom(*axis, front, side, other, sigma)};
}

}  // namespace fulbito::localization
