#pragma once

#include <span>
#include <vector>

#include "navigation/followers/speed_profile.hpp"
#include "navigation/geometry/cubic_spline.hpp"
#include "navigation/obstacles/forecast.hpp"

namespace fulbito {

/// A spline to drive along: densely sampled, with the allowed speed at each point and the robot's place.
class DrivePath {
 public:
  DrivePath();
  void clear();
  /// Samples `spline` and limits its speeds. Only bends and the end limit them, since the limiter handles
  /// acceleration.
  void build(const CubicSpline& spline, SpeedLimits limits);
  /// A straight way ahead with speed 0: the robot brakes without turning.
  void brake(Vec2 position, Vec2 direction, double length);

  bool empty() const { return points_.empty(); }
  std::span<const Vec2> points() const { return points_; }
  std::span<const double> speeds() const { return speeds_; }
  double length() const { return spacing_.empty() ? 0.0 : spacing_.back(); }

  /// Moves the robot's place to the nearest point ahead. Returns the distance [m] to it.
  double advanceTo(Vec2 position);
  std::size_t place() const { return place_; }
  bool finished() const { return place_ + 1 >= points_.size(); }
  /// Direction of the path a little ahead of the robot's place.
  Vec2 directionAhead() const;
  /// Index of the spline's span that the robot is in.
  std::size_t span() const;

  /// The motion that `conflict` simulates: driving on along the path from the robot's place.
  struct Ride {
    double speed = 0.0;           ///< [m/s] present speed
    double top = 1e9;             ///< [m/s] speed to which the ride brakes or accelerates
    double acceleration = 5.0;    ///< [m/s^2]
    double hold = 0.0;            ///< [s] time of turning before the robot can accelerate
    double end = 1e9;             ///< [m] along the path; discs at rest do not count beyond it
    double horizon = 0.8;         ///< [s]
    double margin = 0.006;        ///< [m] least clearance at the start
    double margin_growth = 0.03;  ///< [m/s] growth of the margin to moving discs
  };
  /// Time [s] at which such a ride first comes too near to a disc by the robot's own motion; infinite if it
  /// does not.
  double conflict(const Ride& ride, const BodyShape& body, std::span<const ForecastDisc> discs) const;

 private:
  std::vector<Vec2> points_;
  std::vector<Vec2> along_;
  std::vector<double> curvature_;
  std::vector<double> speeds_;
  std::vector<double> spacing_;  ///< [m] length of the path from the first point
  std::size_t place_ = 0;
};

}  // namespace fulbito
