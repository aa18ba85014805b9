#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "navigation/followers/speed_profile.hpp"
#include "navigation/geometry/cubic_spline.hpp"
#include "navigation/obstacles/forecast.hpp"

namespace fulbito {

/// What a spline is judged by: the robot's limits, the obstacles and what is wanted at both ends.
struct SplineTask {
  SpeedLimits limits;  ///< start_speed: the robot's; end_speed: 0 to stop at the goal
  BodyShape body;
  double clearance_wish = 0.03;    ///< [m] of the body's rectangle, that the plan pays time for
  double clearance_least = 0.008;  ///< [m] below it a plan counts as blocked
  const FieldGeometry* field = nullptr;
  std::span<const ForecastDisc> discs;
  std::optional<Vec2> start_direction;  ///< unit vector; a start at rest pays for turning away from it
  std::optional<Vec2> end_direction;    ///< unit vector; a stop at the goal pays for turning to it
};

/// Verdict on one spline.
struct SplineScore {
  double cost = std::numeric_limits<double>::infinity();  ///< [s] travel time and penalties
  double time = 0.0;                                      ///< [s]
  double clearance =
      0.0;  ///< [m] least of the rectangle, the wish at most, a few centimetres at the ends left out
};

/// Travel time under wheel and grip limits, with penalties for little clearance, of a robot that drives
/// along a spline; obstacles are where they will be when the robot comes by.
///
/// Limits at curvature k and its change k' along the way, half axle track h, wheel acceleration A: speed
/// v (1 + h|k|) <= v_max, v^2 |k| <= lateral grip, |dv/dt| (1 + h|k|) + h v^2 |k'| <= A (the outer wheel's
/// acceleration).
class SplineCost {
 public:
  static constexpr std::size_t kPerSpan = 4;
  static constexpr std::size_t kMaxSamples = (CubicSpline::kMaxControls - 1) * kPerSpan + 1;

  explicit SplineCost(const SplineTask& task = {});
  /// @param enough  a cost from which on the verdict may be left unfinished: the spline is not wanted then
  SplineScore operator()(const CubicSpline& spline, double enough = std::numeric_limits<double>::infinity());

  /// Judges by `task` from now on.
  void setTask(const SplineTask& task);
  const SplineTask& task() const { return task_; }

 private:
  void sample(const CubicSpline& spline);
  void limitSpeeds();
  double passTimes();
  double clearanceAt(Vec2 position, Vec2 along, double time) const;
  /// Half way between samples `i` and `i + 1`.
  double clearanceAfter(std::size_t i) const;
  void payClearance(SplineScore& score) const;
  double payEnds() const;

  SplineTask task_;
  Vec2 inner_;          ///< [m] |x| and |y| up to which walls are too far to matter
  double reach_ = 0.0;  ///< [m] from the body's middle within which a disc's surface matters
  std::size_t count_ = 0;
  double folds_ = 0.0;  ///< turns between samples that are too sharp to be bends, summed
  std::array<Vec2, kMaxSamples> position_;
  std::array<Vec2, kMaxSamples> along_;
  std::array<double, kMaxSamples> curvature_;
  std::array<double, kMaxSamples> step_;    ///< [m] to the next sample
  std::array<double, kMaxSamples> square_;  ///< [m^2/s^2] speed squared
  std::array<double, kMaxSamples> room_;    ///< [m/s^2] wheel acceleration left for the speed, per robot's
  std::array<double, kMaxSamples> time_;    ///< [s] of passing
};

}  // namespace fulbito
