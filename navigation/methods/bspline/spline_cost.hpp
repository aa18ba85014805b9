#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "navigation/followers/speed_profile.hpp"
#include "navigation/geometry/cubic_spline.hpp"
#include "navigation/obstacles/forecast.hpp"

namespace fulbito {

/// The conditions by which splines are rated: robot limits, obstacles, and wishes at both ends.
struct SplineTask {
  SpeedLimits limits;  ///< start_speed is the robot's speed; end_speed 0 means a stop at the goal
  BodyShape body;
  double clearance_wish = 0.03;    ///< [m] clearance of the body's rectangle; less costs time
  double clearance_least = 0.008;  ///< [m] a plan with less clearance counts as blocked
  const FieldGeometry* field = nullptr;
  std::span<const ForecastDisc> discs;
  std::optional<Vec2> start_direction;  ///< unit vector; a robot at rest pays for turning away from it
  std::optional<Vec2> end_direction;    ///< unit vector; a stop at the goal pays for turning to it
};

/// Rating of one spline.
struct SplineScore {
  double cost = std::numeric_limits<double>::infinity();  ///< [s] travel time and penalties
  double time = 0.0;                                      ///< [s]
  double clearance = 0.0;  ///< [m] least clearance of the rectangle without the ends, at most the wish
};

/// Rates a spline by travel time under wheel and grip limits, with penalties for small clearance. Moving
/// obstacles are at their predicted places when the robot passes.
///
/// Limits at curvature k with the derivative k' along the path, half axle track h and wheel acceleration A: v
/// (1 + h|k|) <= v_max, v^2 |k| <= lateral grip, |dv/dt| (1 + h|k|) + h v^2 |k'| <= A (acceleration of the
/// outer wheel).
class SplineCost {
 public:
  static constexpr std::size_t kPerSpan = 4;
  static constexpr std::size_t kMaxSamples = (CubicSpline::kMaxControls - 1) * kPerSpan + 1;

  explicit SplineCost(const SplineTask& task = {});
  /// @param enough  a spline with this cost is not wanted; its rating may stop there
  SplineScore operator()(const CubicSpline& spline, double enough = std::numeric_limits<double>::infinity());

  /// Sets the task for the next ratings.
  void setTask(const SplineTask& task);
  const SplineTask& task() const { return task_; }

 private:
  void sample(const CubicSpline& spline);
  void limitSpeeds();
  double passTimes();
  double clearanceAt(Vec2 position, Vec2 along, double time) const;
  /// Clearance [m] halfway between the samples `i` and `i + 1`.
  double clearanceAfter(std::size_t i) const;
  void payClearance(SplineScore& score) const;
  double payEnds() const;

  SplineTask task_;
  Vec2 inner_;          ///< [m] |x| and |y| up to which walls are too far away to matter
  double reach_ = 0.0;  ///< [m] from the body's centre; discs whose surface is farther do not matter
  std::size_t count_ = 0;
  double folds_ = 0.0;  ///< sum over the turns between samples that are too sharp to be bends
  std::array<Vec2, kMaxSamples> position_;
  std::array<Vec2, kMaxSamples> along_;
  std::array<double, kMaxSamples> curvature_;
  std::array<double, kMaxSamples> step_;    ///< [m] to the next sample
  std::array<double, kMaxSamples> square_;  ///< [m^2/s^2] speed squared
  std::array<double, kMaxSamples> room_;    ///< [m/s^2] acceleration of the robot that the wheels have left
  std::array<double, kMaxSamples> time_;    ///< [s] when the robot passes
};

}  // namespace fulbito
