#include "python/environments/match/observations.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "python/environments/match/compat.hpp"
#include "python/environments/sight.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kBall = 4, kSelf = 9, kOther = 8, kGame = 3;  // numbers of each part
constexpr double kManyGoals = 10.0;                                 // ahead: the scale of the score

}  // namespace

/// Writes numbers one after the other.
class ObservationWriter::Numbers {
 public:
  explicit Numbers(std::span<float> out) : begin_(out.data()), next_(begin_) {}

  void add(double value) { *next_++ = static_cast<float>(value); }
  void add(Vec2 v) {
    add(v.x);
    add(v.y);
  }
  void skip(std::size_t count) {
    std::fill_n(next_, count, 0.0f);
    next_ += count;
  }
  void copy(std::span<const float> numbers) { next_ = std::copy(numbers.begin(), numbers.end(), next_); }
  /// Brings all numbers within the bound.
  void clip(float bound) {
    for (float* number = begin_; number != next_; ++number) *number = std::clamp(*number, -bound, bound);
  }

 private:
  float* begin_;
  float* next_;
};

ObservationWriter::ObservationWriter(ObservationForm form, const MatchConfig& match)
    : form_(form),
      field_(match.field),
      robot_(match.robot.robot),
      half_seconds_(match.rules.half_seconds),
      per_place_(2.0 / match.field.length),
      per_speed_(1.0 / match.robot.robot.maxSpeed()),
      per_yaw_(match.robot.robot.axle_track / (2.0 * match.robot.robot.maxSpeed())),
      per_wheel_(1.0 / match.robot.robot.max_wheel_speed),
      team_(static_cast<std::size_t>(match.rules.team_size)) {
  size_ = kBall + kSelf + (2 * team_ - 1) * kOther + kGame;
  if (form == ObservationForm::kEgocentric) size_ = RobotSight(team_).size();
  if (form == ObservationForm::kCompat) size_ = kCompatNumbers;
}

float ObservationWriter::bound() const {
  switch (form_) {
    case ObservationForm::kCompat:
      return kCompatBound;
    case ObservationForm::kEgocentric:
      return kSightBound;
    case ObservationForm::kAbsolute:
      break;
  }
  return kObservedBound;
}

void ObservationWriter::addRobot(const ObservedRobot& robot, Numbers& numbers) const {
  if (!robot.present) return numbers.skip(kOther);
  numbers.add(1.0);
  numbers.add(robot.state.pose.position * per_place_);
  numbers.add(math::unit(robot.state.pose.heading));
  numbers.add(robot.state.velocity * per_speed_);
  numbers.add(robot.state.angular_velocity * per_yaw_);
}

void ObservationWriter::addGame(const Observation& seen, Numbers& numbers) const {
  numbers.add(seen.playing ? 1.0 : 0.0);
  numbers.add(seen.remaining / half_seconds_);
  numbers.add((seen.own_score - seen.opponent_score) / kManyGoals);
}

std::size_t ObservationWriter::stateSize() const { return kBall + 2 * team_ * kOther + kGame; }

void ObservationWriter::writeState(const Observation& seen, std::span<float> out) const {
  Numbers numbers(out);
  numbers.add(seen.ball.position * per_place_);
  numbers.add(seen.ball.velocity * per_speed_);
  for (const auto* team : {&seen.own, &seen.opponents}) {
    for (std::size_t i = 0; i < team_; ++i) addRobot((*team)[i], numbers);
  }
  addGame(seen, numbers);
  numbers.clip(kObservedBound);
}

void ObservationWriter::share(const Observation& seen, std::span<float> shared) const {
  if (form_ == ObservationForm::kAbsolute) writeState(seen, shared);
}

int ObservationWriter::write(const Observation& seen, std::size_t robot, std::span<float> out) const {
  std::vector<float> shared(sharedSize());
  share(seen, shared);
  return write(seen, shared, robot, out);
}

int ObservationWriter::write(const Observation& seen, std::span<const float> shared, std::size_t robot,
                             std::span<float> out) const {
  if (form_ == ObservationForm::kCompat) return writeCompat(seen, out);
  if (!seen.own[robot].present) {
    std::fill(out.begin(), out.end(), 0.0f);
    return 0;
  }
  if (form_ == ObservationForm::kEgocentric) {
    RobotSight::Moment moment{seen, field_, robot_, robot};
    moment.elapsed = 1.0 - seen.remaining / half_seconds_;
    return RobotSight(team_).write(moment, out);
  }
  const WheelSpeeds& wheels = seen.own[robot].state.wheels;
  const auto own = shared.subspan(kBall), self = own.subspan(robot * kOther, kOther);
  Numbers numbers(out);
  numbers.copy(shared.first(kBall));
  numbers.copy(self.subspan(1));  // without its presence
  numbers.add(Vec2{wheels.left, wheels.right} * per_wheel_);
  numbers.copy(own.first(robot * kOther));
  numbers.copy(own.subspan((robot + 1) * kOther));
  numbers.clip(kObservedBound);
  const auto at_bound = [](float number) { return std::abs(number) >= kObservedBound; };
  return static_cast<int>(std::count_if(out.begin(), out.end(), at_bound));
}

}  // namespace fulbito
