#include "navigation/methods/bspline/spline_cost.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kCrawl = 0.01;          // [m/s] least speed of a plan
constexpr double kSwingShare = 0.8;      // greatest share of the acceleration for changes of the yaw rate
constexpr double kLeastShare = 0.1;      // least share of the wheel acceleration that remains for the speed
constexpr double kForeseen = 1.5;        // [s] plans ignore the motion of discs beyond this time
constexpr double kLeastAgreement = 0.5;  // least cosine between samples; curvature does not show cusps
constexpr double kFoldPrice = 3.0;       // [s] per fold
constexpr double kEndZone = 0.05;        // [m] at both ends, where the plan cannot choose the clearance
constexpr double kTight = 0.02;          // [m] below this clearance the middle between samples is checked too
constexpr double kWishPrice = 0.4;       // [s/m] for driving with no clearance left
constexpr double kBlockedPrice = 20.0;   // [s/m] at the least clearance; twice as much at none
constexpr double kTooFastPrice = 2.0;    // [s] per [m/s] of excess speed at the start
constexpr double kStartTurnPrice = 0.2;  // [s] for half a turn at the start
constexpr double kEndTurnPrice = 0.5;    // [s] for half a turn at the goal, including settling

constexpr auto kWeights = splineWeightTable<SplineCost::kPerSpan>();

/// Sine of half the angle between unit vectors: 0 for equal directions, 1 for opposite ones.
double halfTurn(Vec2 a, Vec2 b) { return std::sqrt(std::max(0.0, 0.5 - 0.5 * dot(a, b))); }

}  // namespace

SplineCost::SplineCost(const SplineTask& task) { setTask(task); }

void SplineCost::setTask(const SplineTask& task) {
  task_ = task;
  reach_ = task.clearance_wish + task.body.circumradius();
  if (task.field == nullptr) return;
  const double border = reach_ + task.field->corner;
  inner_ = {task.field->length / 2 - border, task.field->width / 2 - border};
}

SplineScore SplineCost::operator()(const CubicSpline& spline, double enough) {
  SplineScore score;
  if (spline.spans() == 0) return score;
  sample(spline);
  limitSpeeds();
  score.time = passTimes();
  score.cost = score.time + payEnds();
  if (score.cost < enough) payClearance(score);
  return score;
}

void SplineCost::sample(const CubicSpline& spline) {
  count_ = spline.spans() * kPerSpan + 1;
  double last_speed = 0.0;
  folds_ = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t span = std::min(i / kPerSpan, spline.spans() - 1);
    const SplinePoint point = spline.at(span, kWeights[i - span * kPerSpan]);
    const double speed = std::max(norm(point.first), 1e-9);
    position_[i] = point.position;
    const double slowness = 1.0 / speed;
    along_[i] = point.first * slowness;
    curvature_[i] = cross(along_[i], point.second) * slowness * slowness;
    if (i > 0) {
      step_[i - 1] = (last_speed + speed) / (2.0 * kPerSpan);
      folds_ += std::max(0.0, kLeastAgreement - dot(along_[i - 1], along_[i]));
    }
    last_speed = speed;
  }
}

void SplineCost::limitSpeeds() {
  const SpeedLimits& limits = task_.limits;
  const double h = limits.axle_track / 2;
  for (std::size_t i = 0; i < count_; ++i) {
    const double k = std::abs(curvature_[i]);
    const double inner = 1.0 / (1.0 + h * k);  // the robot's speed per speed of the outer wheel
    const double by_wheel = limits.max_speed * inner;
    const std::size_t next = std::min(i + 1, count_ - 1), from = next - 1;
    const double swing = h * std::abs(curvature_[next] - curvature_[from]) / std::max(step_[from], 1e-9);
    double square = by_wheel * by_wheel;
    if (square * k > limits.lateral) square = limits.lateral / k;
    if (square * swing > kSwingShare * limits.acceleration)
      square = kSwingShare * limits.acceleration / swing;
    square_[i] = std::max(square, kCrawl * kCrawl);
    const double left = limits.acceleration - swing * square_[i];
    room_[i] = std::max(left, kLeastShare * limits.acceleration) * inner;
  }
}

double SplineCost::passTimes() {
  const double start = std::max(task_.limits.start_speed, kCrawl);
  const double end = std::max(task_.limits.end_speed, kCrawl);
  square_[0] = std::min(square_[0], start * start);
  for (std::size_t i = 1; i < count_; ++i) {
    square_[i] = std::min(square_[i], square_[i - 1] + 2.0 * room_[i - 1] * step_[i - 1]);
  }
  square_[count_ - 1] = std::min(square_[count_ - 1], end * end);
  for (std::size_t i = count_ - 1; i-- > 0;) {
    square_[i] = std::min(square_[i], square_[i + 1] + 2.0 * room_[i] * step_[i]);
  }
  time_[0] = 0.0;
  double last = std::sqrt(square_[0]);
  for (std::size_t i = 1; i < count_; ++i) {
    const double speed = std::sqrt(square_[i]);
    time_[i] = time_[i - 1] + 2.0 * step_[i - 1] / (last + speed);
    last = speed;
  }
  return time_[count_ - 1];
}

double SplineCost::payEnds() const {
  const double start = std::sqrt(square_[0]);
  double price = kTooFastPrice * std::max(0.0, task_.limits.start_speed - start);
  price += kFoldPrice * folds_;
  if (task_.start_direction) price += kStartTurnPrice * halfTurn(*task_.start_direction, along_[0]);
  if (task_.end_direction) price += kEndTurnPrice * halfTurn(*task_.end_direction, along_[count_ - 1]);
  return price;
}

double SplineCost::clearanceAt(Vec2 position, Vec2 along, double time) const {
  const double wish = task_.clearance_wish;
  double clearance = wish;
  if (std::abs(position.x) > inner_.x || std::abs(position.y) > inner_.y) {
    const double to_wall = wallClearance(task_.body, position, along, *task_.field);
    // Walls are straight and do not move, so half of the wanted clearance is enough.
    if (to_wall < wish / 2) clearance = to_wall;
  }
  for (const ForecastDisc& disc : task_.discs) {
    if (disc.moves && time > kForeseen) continue;
    const Vec2 centre = disc.at(time);
    const double near = reach_ + disc.radius;
    if (squaredNorm(centre - position) > near * near) continue;
    clearance = std::min(clearance, discClearance(task_.body, position, along, centre, disc.radius));
  }
  return clearance;
}

double SplineCost::clearanceAfter(std::size_t i) const {
  const Vec2 bow = (along_[i] - along_[i + 1]) * (step_[i] / 8.0);
  const Vec2 middle = (position_[i] + position_[i + 1]) / 2.0 + bow;
  return clearanceAt(middle, unitOr(along_[i] + along_[i + 1], along_[i]), (time_[i] + time_[i + 1]) / 2.0);
}

void SplineCost::payClearance(SplineScore& score) const {
  const double wish = task_.clearance_wish, least = task_.clearance_least;
  double way = 0.0, total = 0.0;
  for (std::size_t i = 0; i + 1 < count_; ++i) total += step_[i];
  score.clearance = 1e9;
  for (std::size_t i = 0; i < count_; ++i) {
    double clearance = clearanceAt(position_[i], along_[i], time_[i]);
    if (clearance < kTight && i + 1 < count_) clearance = std::min(clearance, clearanceAfter(i));
    const double length = i + 1 < count_ ? step_[i] : step_[i - 1];
    if (clearance < wish) {
      const double missing = (wish - clearance) / wish;
      score.cost += kWishPrice * length * missing * missing;
      if (clearance < least) score.cost += kBlockedPrice * length * (1.0 + (least - clearance) / least);
    }
    if (way > kEndZone && total - way > kEndZone) score.clearance = std::min(score.clearance, clearance);
    if (i + 1 < count_) way += step_[i];
  }
}

}  // namespace fulbito
