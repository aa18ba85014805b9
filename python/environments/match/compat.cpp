#include "python/environments/match/compat.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kTeam = 3;               // robots per team
constexpr double kLargestPlace = 0.75 + 0.15;  // [m] half the field's length and the penalty area's depth
constexpr double kMotor = 440.0 / 60.0 * 2.0 * math::kPi;  // [rad/s] 440 turns per minute
constexpr double kLargestSpeed = kMotor * 0.026;           // [m/s] rim of a wheel
constexpr double kLargestYaw = kLargestSpeed / 0.04;       // [rad/s] half a robot and a wheel's thickness
constexpr double kStands = 0.05;                           // [m/s] slower wheels stand
constexpr double kMove = 0.2, kGradient = 0.8, kEnergy = 2e-4, kGoal = 10.0;  // weights
constexpr double kWalk = 0.4;  // [m/s] that counts as 1 in `move`
constexpr double kMost = 5.0;  // of a term before its weight

enum Term : std::size_t { kGoalTerm, kMoveTerm, kGradientTerm, kEnergyTerm };

class Writer {
 public:
  explicit Writer(std::span<float> out) : out_(out) {}
  void add(double value) {
    const double kept = std::clamp(value, -double{kCompatBound}, double{kCompatBound});
    clipped_ += kept == value ? 0 : 1;
    out_[at_++] = std::clamp(static_cast<float>(kept), -kCompatBound, kCompatBound);
  }
  void add(Vec2 value, double scale) {
    add(value.x / scale);
    add(value.y / scale);
  }
  int clipped() const { return clipped_; }

 private:
  std::span<float> out_;
  std::size_t at_ = 0;
  int clipped_ = 0;
};

}  // namespace

int writeCompat(const Observation& seen, std::span<float> out) {
  Writer writer(out);
  writer.add(seen.ball.position, kLargestPlace);
  writer.add(seen.ball.velocity, kLargestSpeed);
  for (const auto* team : {&seen.own, &seen.opponents}) {
    for (std::size_t i = 0; i < kTeam; ++i) {
      const RobotState& robot = (*team)[i].state;
      writer.add(robot.pose.position, kLargestPlace);
      if (team == &seen.own) {
        writer.add(math::sin(robot.pose.heading));
        writer.add(math::cos(robot.pose.heading));
      }
      writer.add(robot.velocity, kLargestSpeed);
      writer.add(robot.angular_velocity / kLargestYaw);
    }
  }
  return writer.clipped();
}

WheelSpeeds compatWheels(const RobotModel& robot, std::span<const float> action) {
  const auto wheel = [&](float share) {
    const double speed = std::clamp(double{share}, -1.0, 1.0) * kLargestSpeed;
    return std::abs(speed) < kStands ? 0.0 : speed / robot.wheel_radius;
  };
  return {wheel(action[0]), wheel(action[1])};
}

void CompatReward::begin() {
  potential_.reset();
  sums_.fill(0.0);
}

double CompatReward::gradient(Vec2 ball, double step) {
  const double half = field_.length / 2 + field_.goal_depth;
  const auto from = [&](double x) { return std::sqrt(x * x + 2.0 * ball.y * ball.y); };
  const double potential = ((from(half + ball.x) - from(half - ball.x)) / field_.length - 1.0) / 2.0;
  const double change = potential_ ? potential - *potential_ : 0.0;
  potential_ = potential;
  return std::clamp(change * 3.0 / step, -kMost, kMost);
}

bool CompatReward::step(const CompatMoment& now, std::span<double> terms) {
  const double line = field_.length / 2;
  if (std::abs(now.ball.position.x) > line) {
    const bool ours = now.ball.position.x > 0.0;
    terms[kGoalTerm] += ours ? kGoal : -kGoal;
    sums_[0] += ours ? 1.0 : -1.0;
    sums_[ours ? 4 : 5] += 1.0;
    return true;
  }
  const Vec2 way = now.ball.position - now.robot.pose.position;
  const double toward = norm(way) > 0.0 ? dot(way / norm(way), now.robot.velocity) : 0.0;
  const double move = kMove * std::clamp(toward / kWalk, -kMost, kMost);
  const double gained = kGradient * gradient(now.ball.position, now.step);
  const double energy = -kEnergy * (std::abs(now.wheels.left) + std::abs(now.wheels.right));
  const std::array<double, 3> parts{move, gained, energy};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    terms[kMoveTerm + i] += parts[i];
    sums_[1 + i] += parts[i];
  }
  return false;
}

}  // namespace fulbito
