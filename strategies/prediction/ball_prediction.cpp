#include "strategies/prediction/ball_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulbito {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// The moving ball under the rules of floor and walls in closed form; engine/sim integrates the same rules.
struct Rolling {
  const BallCourse& course;
  BallState ball;
  Vec2 slip_direction;
  bool slides = false;

  /// Motion of the stretch that begins now, and its duration [s]; infinite if the ball rests.
  std::pair<EvenMotion, double> stretch() {
    constexpr double kLeastSlip = 1e-4;  // [m/s]
    const BallModel& model = course.ball;
    const Vec2 slip = ball.velocity - ball.spin;
    const double slip_speed = norm(slip);
    slides = slip_speed > kLeastSlip;
    if (slides) {
      slip_direction = slip / slip_speed;
      return {{ball.position, ball.velocity, -model.slide_deceleration * slip_direction},
              slip_speed * (1.0 - model.roll_keep) / model.slide_deceleration};
    }
    const double speed = norm(ball.velocity);
    if (speed <= model.stop_speed || !(model.roll_deceleration > 0.0)) {
      return {{ball.position, speed <= model.stop_speed ? Vec2{} : ball.velocity, {}}, kForever};
    }
    return {{ball.position, ball.velocity, ball.velocity * (-model.roll_deceleration / speed)},
            (speed - model.stop_speed) / model.roll_deceleration};
  }

  Vec2 spinChange() const {
    const BallModel& model = course.ball;
    if (slides)
      return slip_direction * (model.slide_deceleration * model.roll_keep / (1.0 - model.roll_keep));
    return unitOr(ball.velocity, {}) * -model.roll_deceleration;
  }

  void advance(const EvenMotion& motion, double time, bool to_the_end) {
    ball.position = motion.positionAt(time);
    ball.velocity = motion.velocityAt(time);
    if (!slides) {
      if (to_the_end) ball.velocity = {};
      ball.spin = ball.velocity;
    } else if (to_the_end) {
      ball.spin = ball.velocity;
    } else {
      ball.spin += spinChange() * time;
    }
  }

  void bounce(Vec2 normal) {
    const BallModel& model = course.ball;
    const double into = -dot(ball.velocity, normal);
    const bool bounces = into > course.restitution_threshold;
    const double restitution = bounces ? model.wall_restitution : 0.0;
    const Vec2 along = perp(normal);
    const double slide = dot(ball.velocity, along);
    const double loss = std::min(std::abs(slide), model.friction * (1.0 + restitution) * into);
    ball.velocity += normal * (into * (1.0 + restitution)) - along * std::copysign(loss, slide);
    // A ball that stays at the wall loses the spin toward it within a few steps.
    const double spin_lost = bounces ? 1.0 - model.wall_spin_keep : 1.0;
    ball.spin -= normal * (dot(ball.spin, normal) * spin_lost);
  }
};

}  // namespace

void BallPrediction::rest(double time, Vec2 position, int bounces) {
  stretches_[static_cast<std::size_t>(count_++)] = {time, {position, {}, {}}, {}, {}, bounces};
}

void BallPrediction::predict(const BallCourse& course, const BallState& ball, double horizon) {
  Rolling rolling{course, ball, {}, false};
  double time = 0.0;
  int bounces = 0;
  count_ = 0;
  while (count_ < kMaxStretches - 1 && time < horizon) {
    const auto [motion, lasts] = rolling.stretch();
    if (lasts == kForever && motion.velocity == Vec2{}) break;
    const double left = std::min(lasts, horizon - time);
    stretches_[static_cast<std::size_t>(count_++)] = {time, motion, rolling.ball.spin, rolling.spinChange(),
                                                      bounces};
    const auto hit = course.walls.firstHit(motion, left);
    const double spent = hit ? hit->time : left;
    rolling.advance(motion, spent, !hit && left == lasts);
    time += spent;
    if (hit) {
      rolling.bounce(hit->normal);
      ++bounces;
    }
  }
  rest(time, rolling.ball.position, bounces);
}

const BallPrediction::Stretch& BallPrediction::stretchAt(double t) const {
  int index = count_ - 1;
  while (index > 0 && stretches_[static_cast<std::size_t>(index)].begin > t) --index;
  return stretches_[static_cast<std::size_t>(index)];
}

double BallPrediction::endOf(int index) const {
  return index + 1 < count_ ? stretches_[static_cast<std::size_t>(index) + 1].begin : kForever;
}

Vec2 BallPrediction::positionAt(double t) const {
  const Stretch& stretch = stretchAt(t);
  return stretch.motion.positionAt(t - stretch.begin);
}

Vec2 BallPrediction::velocityAt(double t) const {
  const Stretch& stretch = stretchAt(t);
  return stretch.motion.velocityAt(t - stretch.begin);
}

BallState BallPrediction::ballAt(double t) const {
  const Stretch& stretch = stretchAt(t);
  const double since = t - stretch.begin;
  return {stretch.motion.positionAt(since), stretch.motion.velocityAt(since),
          stretch.spin + stretch.spin_change * since};
}

int BallPrediction::bouncesBefore(double t) const { return stretchAt(t).bounces; }

std::optional<BallPrediction::Crossing> BallPrediction::crossing(Vec2 point, Vec2 normal, double from) const {
  for (int i = 0; i + 1 < count_; ++i) {
    const Stretch& stretch = stretches_[static_cast<std::size_t>(i)];
    const double lasts = endOf(i) - stretch.begin, skipped = std::max(0.0, from - stretch.begin);
    if (skipped > lasts) continue;
    const EvenMotion motion{stretch.motion.positionAt(skipped), stretch.motion.velocityAt(skipped),
                            stretch.motion.acceleration};
    const double before = dot(point - motion.position, normal);
    if (before < 0.0) continue;
    const auto time =
        timeOfFall(before, -dot(motion.velocity, normal), -dot(motion.acceleration, normal), lasts - skipped);
    if (!time) continue;
    return Crossing{stretch.begin + skipped + *time, motion.positionAt(*time), motion.velocityAt(*time)};
  }
  return std::nullopt;
}

void BallPrediction::sample(std::span<Vec2> points, double step) const {
  std::size_t i = 0;
  for (int index = 0; i < points.size(); ++index) {
    const double begin = stretches_[static_cast<std::size_t>(index)].begin, end = endOf(index);
    const EvenMotion motion = stretches_[static_cast<std::size_t>(index)].motion;
    for (; i < points.size(); ++i) {
      const double t = static_cast<double>(i + 1) * step;
      if (end <= t) break;
      points[i] = motion.positionAt(t - begin);
    }
  }
}

}  // namespace fulbito
