#include "python/environments/sight.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kTasks = 6;
constexpr std::size_t kOfRobot = 7;    // numbers of another robot
constexpr std::size_t kOfOthers = 36;  // numbers of all but other robots

void addOthers(std::vector<SightEntry>& entries, const std::string& whose, std::size_t count) {
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string name = fmt::format("{}-{}", whose, i);
    entries.push_back({name + "-present", "", "1: there is such a robot; else all of its numbers are 0"});
    entries.push_back({name + "-x", "m", "ahead of the agent's robot; the nearest robot comes first"});
    entries.push_back({name + "-y", "m", "to its left"});
    entries.push_back({name + "-vx", "", "velocity along the agent's heading, over the top speed"});
    entries.push_back({name + "-vy", "", "to its left, over the top speed"});
    entries.push_back({name + "-cos", "", "cosine of its heading, seen from the agent's"});
    entries.push_back({name + "-sin", "", "sine of the same"});
  }
}

std::vector<SightEntry> entriesOfAll(std::size_t team) {
  std::vector<SightEntry> entries;
  for (const char* task : {"play", "reach-pose", "turn", "reach-ball", "push", "predict-ball"}) {
    entries.push_back({fmt::format("task-{}", task), "", "1: the trial's task is this"});
  }
  const std::vector<SightEntry> own = {
      {"x", "m", "the robot's place in the team's frame: its own goal is at -x"},
      {"y", "m", "the same"},
      {"cos", "", "cosine of its heading in that frame"},
      {"sin", "", "sine of the same"},
      {"forward", "", "its speed along its heading, over the top speed"},
      {"sideways", "", "its speed to its left, over the top speed"},
      {"yaw", "", "its yaw rate, over that of a spin at top speed"},
      {"sent-left", "", "the last command of the left wheel, over its top speed"},
      {"sent-right", "", "the same of the right wheel"},
      {"ball-x", "m", "the ball ahead of the robot"},
      {"ball-y", "m", "the ball to its left"},
      {"ball-vx", "", "the ball's velocity along the robot's heading, over the top speed"},
      {"ball-vy", "", "the ball's velocity to its left, over the top speed"},
      {"ball-distance", "m", "distance of the ball"},
      {"ball-cos", "", "cosine of the ball's bearing"},
      {"ball-sin", "", "sine of the same"},
      {"goal-x", "m", "the middle of the opponents' goal ahead of the robot"},
      {"goal-y", "m", "the same to its left"},
      {"own-goal-x", "m", "the middle of the own goal ahead of the robot"},
      {"own-goal-y", "m", "the same to its left"},
      {"shot-cos", "",
       "cosine of the direction from the ball to the opponents' goal, seen from the robot's heading"},
      {"shot-sin", "", "sine of the same"},
      {"target-x", "m", "the task's target ahead of the robot; 0 without a task"},
      {"target-y", "m", "the same to its left"},
      {"target-cos", "", "cosine of the task's heading, seen from the robot's"},
      {"target-sin", "", "sine of the same"},
      {"target-speed", "", "speed that the task asks for, over the top speed"},
      {"horizon", "s", "time ahead of the prediction that the task asks for"},
      {"elapsed", "", "share of the trial, or of the half, that is over"},
      {"playing", "", "1: play is on; 0: a restart waits for its signal"}};
  entries.insert(entries.end(), own.begin(), own.end());
  addOthers(entries, "mate", team - 1);
  addOthers(entries, "opponent", team);
  return entries;
}

/// Writes numbers as the agent's robot sees them.
class Eyes {
 public:
  Eyes(const RobotState& self, const RobotModel& model, std::span<float> out)
      : self_(self), axis_(math::unit(self.pose.heading)), top_speed_(model.maxSpeed()), out_(out) {}

  void number(double value) {
    const auto bound = static_cast<double>(kSightBound);
    const double kept = std::clamp(value, -bound, bound);
    clipped_ += kept == value ? 0 : 1;
    out_[at_++] = static_cast<float>(kept);
  }
  void pair(Vec2 v) {
    number(v.x);
    number(v.y);
  }
  void place(Vec2 p) { pair(intoFrame(axis_, p - self_.pose.position)); }
  void velocity(Vec2 v) { pair(intoFrame(axis_, v) / top_speed_); }
  void direction(double angle) { pair(math::unit(angle - self_.pose.heading)); }
  int clipped() const { return clipped_; }
  void zeros(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) number(0.0);
  }

  void robot(const RobotState& other) {
    number(1.0);
    place(other.pose.position);
    velocity(other.velocity);
    direction(other.pose.heading);
  }

 private:
  const RobotState& self_;
  Vec2 axis_;
  double top_speed_;
  std::span<float> out_;
  std::size_t at_ = 0;
  int clipped_ = 0;
};

/// The robots that are present, but for `without`: the nearest first.
void writeNearest(Eyes& eyes, Vec2 from, const std::array<ObservedRobot, kMaxTeamSize>& robots,
                  std::size_t without, std::size_t wanted) {
  std::array<const RobotState*, kMaxTeamSize> found{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (i != without && robots[i].present) found[count++] = &robots[i].state;
  }
  std::stable_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                   [&](const RobotState* a, const RobotState* b) {
                     return squaredNorm(a->pose.position - from) < squaredNorm(b->pose.position - from);
                   });
  for (std::size_t i = 0; i < wanted; ++i) {
    if (i < count) {
      eyes.robot(*found[i]);
    } else {
      eyes.zeros(kOfRobot);
    }
  }
}

void writeTask(Eyes& eyes, const RobotSight::Moment& moment) {
  constexpr std::size_t kNumbers = 6;
  if (moment.task == DrillTask::kPlay || moment.exercise == nullptr) return eyes.zeros(kNumbers);
  const Exercise& exercise = *moment.exercise;
  eyes.place(moment.task == DrillTask::kPredictBall ? moment.seen.ball.position : exercise.target);
  eyes.direction(exercise.heading);
  eyes.number(exercise.speed / moment.model.maxSpeed());
  eyes.number(exercise.horizon);
}

}  // namespace

std::vector<SightEntry> RobotSight::entries() const { return entriesOfAll(team_); }

std::size_t RobotSight::size() const { return kOfOthers + (2 * team_ - 1) * kOfRobot; }

int RobotSight::write(const Moment& moment, std::span<float> out) const {
  const Observation& seen = moment.seen;
  const RobotModel& model = moment.model;
  const RobotState& self = seen.own[moment.robot].state;
  Eyes eyes(self, model, out);
  for (std::size_t i = 0; i < kTasks; ++i)
    eyes.number(static_cast<std::size_t>(moment.task) == i ? 1.0 : 0.0);
  eyes.pair(self.pose.position);
  eyes.pair(math::unit(self.pose.heading));
  eyes.velocity(self.velocity);
  eyes.number(self.angular_velocity * model.axle_track / (2.0 * model.maxSpeed()));
  const WheelSpeeds sent = seen.sent[moment.robot];
  eyes.pair(Vec2{sent.left, sent.right} / model.max_wheel_speed);
  eyes.place(seen.ball.position);
  eyes.velocity(seen.ball.velocity);
  eyes.number(distance(seen.ball.position, self.pose.position));
  eyes.direction(math::angleOf(seen.ball.position - self.pose.position));
  const Vec2 goal{moment.field.length / 2, 0.0};
  eyes.place(goal);
  eyes.place(-goal);
  eyes.direction(math::angleOf(goal - seen.ball.position));
  writeTask(eyes, moment);
  eyes.number(moment.elapsed);
  eyes.number(seen.playing ? 1.0 : 0.0);
  writeNearest(eyes, self.pose.position, seen.own, moment.robot, team_ - 1);
  writeNearest(eyes, self.pose.position, seen.opponents, kMaxTeamSize, team_);
  return eyes.clipped();
}

}  // namespace fulbito
