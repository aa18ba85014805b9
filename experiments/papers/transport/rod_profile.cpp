#include "experiments/papers/transport/rod_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fulbito {
namespace {

/// One robot's part of a point on the curve. Derivatives are by the length of the curve.
struct CurveShare {
  double q = 0.0;
  double rate = 0.0;  // q', derivative of q
  double bend = 0.0;  // q'' [1/m]
  double jump = 0.0;  // [1/m] jump of the path's curvature here
  double curvature = 0.0;
};

struct CurveRow {
  double along = 0.0;
  std::array<CurveShare, 2> shares;
  double pace = 0.0;  // [m/s] along the curve
};

class Profiler {
 public:
  Profiler(const TransportTask& task, const ConstraintCurve& curve, const RobotModel& robot,
           const RodPace& pace);
  std::vector<RodReference> run(double tick);

 private:
  CurveRow rowAt(const CurvePoint& point) const;
  double wheelShare(const CurveShare& share) const;
  double limitOf(const CurveShare& share) const;
  double gainAt(const CurveRow& row) const;
  void differ();
  void limit();
  void smooth();
  RodReference between(std::size_t i, double share) const;

  const TransportTask& task_;
  const ConstraintCurve& curve_;
  RodPace pace_;
  double half_track_;
  double wheel_limit_;   // [m/s] of a rim
  double acceleration_;  // [m/s^2]
  double sign_;
  std::vector<CurveRow> rows_;
};

Profiler::Profiler(const TransportTask& task, const ConstraintCurve& curve, const RobotModel& robot,
                   const RodPace& pace)
    : task_(task),
      curve_(curve),
      pace_(pace),
      half_track_(robot.axle_track / 2),
      wheel_limit_(robot.maxSpeed()),
      acceleration_(pace.acceleration_share * std::min(robot.wheel_acceleration, robot.wheel_braking)),
      sign_(travelSign(task)) {
  for (const CurvePoint& point : curve.points) rows_.push_back(rowAt(point));
  differ();
  limit();
  smooth();
}

CurveRow Profiler::rowAt(const CurvePoint& point) const {
  const RodView view = viewRod(task_.path, point.lead, point.follower);
  const double size = std::sqrt(view.lead * view.lead + view.follower * view.follower);
  CurveRow row;
  row.along = point.along;
  row.shares[0] = {point.lead.q, sign_ * view.follower / size, 0.0, 0.0,
                   task_.path.parts()[point.lead.part].curvature};
  row.shares[1] = {point.follower.q, sign_ * view.lead / size, 0.0, 0.0,
                   task_.path.parts()[point.follower.part].curvature};
  return row;
}

void Profiler::differ() {
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      CurveShare &now = rows_[i].shares[k], &next = rows_[i + 1].shares[k];
      const double step = rows_[i + 1].along - rows_[i].along;
      now.bend = std::max(std::abs(now.bend), std::abs(next.rate - now.rate) / step);
      next.bend = std::abs(next.rate - now.rate) / step;
      next.jump = std::abs(next.curvature - now.curvature);
    }
  }
}

// Speed of the faster rim relative to the robot's speed.
double Profiler::wheelShare(const CurveShare& share) const {
  return 1.0 + std::abs(share.curvature) * half_track_;
}

// Half of the acceleration is for the curve's bends, and the other half for changes of pace.
double Profiler::limitOf(const CurveShare& share) const {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto over = [&](double limit, double rate) { return rate > 0.0 ? limit / rate : infinite; };
  const double rate = std::abs(share.rate), wheels = wheelShare(share);
  return std::min({over(pace_.speed, rate), over(wheel_limit_, rate * wheels),
                   std::sqrt(over(acceleration_ / 2, share.bend * wheels)),
                   over(acceleration_ * pace_.bend_time, rate * share.jump * half_track_)});
}

void Profiler::limit() {
  for (CurveRow& row : rows_) row.pace = std::min(limitOf(row.shares[0]), limitOf(row.shares[1]));
  rows_.front().pace = rows_.back().pace = 0.0;
}

double Profiler::gainAt(const CurveRow& row) const {
  double gain = std::numeric_limits<double>::infinity();
  for (const CurveShare& share : row.shares)
    gain = std::min(gain, acceleration_ / 2 / std::max(std::abs(share.rate) * wheelShare(share), 1e-9));
  return gain;
}

void Profiler::smooth() {
  const auto reachable = [&](const CurveRow& from, const CurveRow& to) {
    const double step = std::abs(to.along - from.along);
    return std::sqrt(from.pace * from.pace + 2 * std::min(gainAt(from), gainAt(to)) * step);
  };
  for (std::size_t i = 1; i < rows_.size(); ++i)
    rows_[i].pace = std::min(rows_[i].pace, reachable(rows_[i - 1], rows_[i]));
  for (std::size_t i = rows_.size() - 1; i-- > 0;)
    rows_[i].pace = std::min(rows_[i].pace, reachable(rows_[i + 1], rows_[i]));
}

RodReference Profiler::between(std::size_t i, double share) const {
  const CurveRow &a = rows_[i], &b = rows_[i + 1];
  const auto mixed = [&](std::size_t k) {
    const CurveShare &from = a.shares[k], &to = b.shares[k];
    const double q = from.q + (to.q - from.q) * share;
    const double speed = from.rate * a.pace + (to.rate * b.pace - from.rate * a.pace) * share;
    return CarrierReference{{task_.path.partAt(q), q}, speed};
  };
  return {mixed(0), mixed(1)};
}

std::vector<RodReference> Profiler::run(double tick) {
  std::vector<RodReference> references;
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const CurveRow &a = rows_[i], &b = rows_[i + 1];
    const double span = 2 * (b.along - a.along) / (a.pace + b.pace);
    while (static_cast<double>(references.size()) * tick < begin + span) {
      // Constant acceleration along the curve.
      const double u = (static_cast<double>(references.size()) * tick - begin) / span;
      references.push_back(between(i, u * (2 * a.pace + (b.pace - a.pace) * u) / (a.pace + b.pace)));
    }
    begin += span;
  }
  references.push_back(between(rows_.size() - 2, 1.0));
  return references;
}

Result<void> checkCorners(const PartPath& path) {
  constexpr double kSmooth = 0.01;  // [rad]
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (std::abs(path.jumpAfter(i)) > kSmooth)
      return fail(ErrorCode::kBadInput, fmt::format("the path has a corner after part {}", i + 1));
  }
  return {};
}

}  // namespace

Result<std::vector<RodReference>> profileAlong(const TransportTask& task, const ConstraintCurve& curve,
                                               const RobotModel& robot, const RodPace& pace, double tick) {
  if (!curve.arrives()) return fail(ErrorCode::kBadInput, refusal(task, curve));
  if (auto smooth = checkCorners(task.path); !smooth) return tl::unexpected<Error>(smooth.error());
  return Profiler(task, curve, robot, pace).run(tick);
}

}  // namespace fulbito
