#include "python/environments/match/observations.hpp"

#include <algorithm>
#include <cmath>

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
  /// Brings all numbers within the bound. @return how many were beyond it
  int clip(float bound) {
    int clipped = 0;
    for (float* number = begin_; number != next_; ++number) {
      const float kept = std::clamp(*number, -bound, bound);
      clipped += kept == *number ? 0 : 1;
      *number = kept;
    }
    return clipped;
  }

 private:
  float* begin_;
  float* next_;
};

Facings::Facings(const Observation& seen) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    if (seen.own[i].present) robots[0][i] = math::unit(seen.own[i].state.pose.heading);
    if (seen.opponents[i].present) robots[1][i] = math::unit(seen.opponents[i].state.pose.heading);
  }
}

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

void ObservationWriter::addRobot(const ObservedRobot& robot, Vec2 facing, Numbers& numbers) const {
  if (!robot.present) return numbers.skip(kOther);
  numbers.add(1.0);
  numbers.add(robot.state.pose.position * per_place_);
  numbers.add(facing);
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
  const Facings facings(seen);
  for (std::size_t i = 0; i < team_; ++i) addRobot(seen.own[i], facings.robots[0][i], numbers);
  for (std::size_t i = 0; i < team_; ++i) addRobot(seen.opponents[i], facings.robots[1][i], numbers);
  addGame(seen, numbers);
  (void)numbers.clip(kObservedBound);
}

int ObservationWriter::write(const Observation& seen, const Facings& facings, std::size_t robot,
                             std::span<float> out) const {
  if (form_ == ObservationForm::kCompat) return writeCompat(seen, out);
  Numbers numbers(out);
  if (!seen.own[robot].present) {
    numbers.skip(out.size());
    return 0;
  }
  if (form_ == ObservationForm::kEgocentric) {
    RobotSight::Moment moment{seen, field_, robot_, robot};
    moment.elapsed = 1.0 - seen.remaining / half_seconds_;
    return RobotSight(team_).write(moment, out);
  }
  const RobotState& self = seen.own[robot].state;
  numbers.add(seen.ball.position * per_place_);
  numbers.add(seen.ball.velocity * per_speed_);
  numbers.add(self.pose.position * per_place_);
  numbers.add(facings.robots[0][robot]);
  numbers.add(self.velocity * per_speed_);
  numbers.add(self.angular_velocity * per_yaw_);
  numbers.add(Vec2{self.wheels.left, self.wheels.right} * per_wheel_);
  for (std::size_t i = 0; i < team_; ++i) {
    if (i != robot) addRobot(seen.own[i], facings.robots[0][i], numbers);
  }
  for (std::size_t i = 0; i < team_; ++i) {
    addRobot(seen.opponents[i], facings.robots[1][i], numbers);
  }
  addGame(seen, numbers);
  return numbers.clip(kObservedBound);
}

}  // namespace fulbito
