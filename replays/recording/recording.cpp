#include "fulbito/recording.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "fulbito/detail/state_hash.hpp"

namespace fulbito {
namespace {

class ShortHash {
 public:
  ShortHash& add(Vec2 v) { return add(v.x).add(v.y); }
  ShortHash& add(double value) {
    hash_.add(value);
    return *this;
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(hash_.value()); }

 private:
  StateHash hash_;
};

BodyHash hashOf(const RobotState& robot) {
  ShortHash place, motion;
  place.add(robot.pose.position).add(robot.pose.heading);
  motion.add(robot.velocity).add(robot.angular_velocity).add(robot.wheels.left).add(robot.wheels.right);
  return {place.value(), motion.value()};
}

BodyHash hashOf(const BallState& ball) {
  ShortHash place, motion;
  place.add(ball.position);
  motion.add(ball.velocity).add(ball.spin);
  return {place.value(), motion.value()};
}

BodyHash hashOf(const ObstacleState& obstacle) {
  ShortHash place, motion;
  place.add(obstacle.pose.position).add(obstacle.pose.heading);
  motion.add(obstacle.velocity);
  return {place.value(), motion.value()};
}

}  // namespace

int countOf(const RecordingHeader& header, BodyKind kind) {
  return static_cast<int>(std::count_if(header.bodies.begin(), header.bodies.end(),
                                        [kind](const RecordedBody& body) { return body.kind == kind; }));
}

double sampleHeadingStep(const RecordingHeader& header) { return 2.0 * math::kPi / header.sample_turn; }

Tick drawingTicks(const RecordingHeader& header) {
  return std::max(header.sample_every, header.control_rate / 5);
}

BodyHash bodyHash(const WorldState& world, std::size_t body) {
  if (body < world.robots.size()) return hashOf(world.robots[body]);
  body -= world.robots.size();
  if (body < world.balls.size()) return hashOf(world.balls[body]);
  return hashOf(world.obstacles[body - world.balls.size()]);
}

}  // namespace fulbito
