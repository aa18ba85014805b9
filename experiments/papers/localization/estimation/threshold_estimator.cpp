#include "experiments/papers/localization/estimation/threshold_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fulbito::localization {
namespace {

/// Slope of the least-squares line; 0 for points with equal x.
double slopeOf(const std::vector<Vec2>& points) {
  Vec2 mean;
  for (Vec2 p : points) mean += p;
  mean = mean / static_cast<double>(points.size());
  double product = 0.0, square = 0.0;
  for (Vec2 p : points) {
    product += (p.x - mean.x) * (p.y - mean.y);
    square += (p.x - mean.x) * (p.x - mean.x);
  }
  return square > 0.0 ? product / square : 0.0;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

ThresholdEstimator::ThresholdEstimator(const Knowledge& known, const ThresholdSettings& settings)
    : known_(known),
      settings_(settings),
      pose_(known.pose),
      reckoned_(known.pose),
      gates_{RangeGate(settings.gate), RangeGate(settings.gate), RangeGate(settings.gate)} {}

void ThresholdEstimator::advance(const InnerMotion& motion) {
  turn_rate_ = motion.turn_rate - known_.gyro_bias;
  const double turned = turn_rate_ * motion.dt;
  const Vec2 before = pose_.position;
  pose_ = movedBy(pose_, motion.distance, turned);
  reckoned_ = movedBy(reckoned_, motion.distance, turned);
  way_ += motion.distance;
  // The direction of the wall along which the robot drives is the nearest quarter turn.
  const double quarter = std::floor(pose_.heading / (math::kPi / 2) + 0.5) * (math::kPi / 2);
  sideways_ += cross(math::unit(quarter), pose_.position - before);
  if (std::abs(pose_.heading - quarter) > steepest()) forgetSlopes();  // the robot turns to another wall
}

double ThresholdEstimator::steepest() const { return std::min(settings_.incidence, known_.cone); }

bool ThresholdEstimator::usable(const WallAhead& wall, double range) const {
  return std::abs(turn_rate_) <= settings_.calm_turn_rate && std::abs(wall.incidence) <= steepest() &&
         range >= settings_.least && range <= settings_.greatest;
}

void ThresholdEstimator::observe(const EchoTimes& times) {
  // The pose is known within the threshold. An echo with a much larger difference is from something else.
  const double limit =
      3.0 * std::sqrt(known_.range_sigma * known_.range_sigma + settings_.threshold * settings_.threshold);
  for (const Beam beam : kBeams) {
    const auto& time = times[indexOf(beam)];
    const double range = time ? *time * known_.echo_speed : 0.0;
    const Vec2 axis = math::unit(reckoned_.heading + directionOf(beam));
    const Vec2 sensor = reckoned_.position + axis * reachOf(known_.body, beam);
    const bool steady =
        gates_[indexOf(beam)].accept(time ? std::optional(range) : std::nullopt, sensor, axis);
    const WallAhead wall = wallAhead(known_.room, known_.body, pose_, beam);
    if (!time || !steady || !usable(wall, range)) continue;
    const double difference = range - wall.distance;
    if (std::abs(difference) > limit) continue;
    correct(beam, wall, difference);
    noteSlope(beam, wall, range);
  }
}

void ThresholdEstimator::correct(Beam beam, const WallAhead& wall, double difference) {
  std::vector<double>& beyond = beyond_[indexOf(beam)];
  const bool goes_on = !beyond.empty() && (beyond.back() > 0.0) == (difference > 0.0);
  if (!goes_on) beyond.clear();
  if (std::abs(difference) <= settings_.threshold) return beyond.clear();
  beyond.push_back(difference);
  if (static_cast<int>(beyond.size()) < settings_.repeats) return;
  const double step = -wall.sign * settings_.gain * meanOf(beyond);
  (wall.across_x ? pose_.position.x : pose_.position.y) += step;
  beyond.clear();
}

void ThresholdEstimator::noteSlope(Beam beam, const WallAhead& wall, double range) {
  if (beam == Beam::kFront) return;
  // Distance that the robot moves to the left of the wall's direction by the echo, relative to dead
  // reckoning.
  const double left = (beam == Beam::kRight ? 1.0 : -1.0) * range * math::cos(wall.incidence);
  WallLine& line = lines_[indexOf(beam)];
  line.points.push_back({way_, left - sideways_});
  if (way_ - line.points.front().x < settings_.heading_way) return;
  turnBySlope(slopeOf(line.points));
}

void ThresholdEstimator::turnBySlope(double slope) {
  pose_.heading = math::wrapAngle(pose_.heading + settings_.heading_gain * math::atan2(slope, 1.0));
  forgetSlopes();
}

void ThresholdEstimator::forgetSlopes() {
  for (WallLine& line : lines_) line.points.clear();
  way_ = sideways_ = 0.0;
}

}  // namespace fulbito::localization
