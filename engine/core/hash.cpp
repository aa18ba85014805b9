#include "engine/core/hash.hpp"

#include <bit>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace fulbito {
namespace {

void addVec(StateHash& hash, Vec2 v) {
  hash.add(v.x);
  hash.add(v.y);
}

}  // namespace

void StateHash::add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }

void StateHash::add(std::uint64_t value) { value_ = XXH3_64bits_withSeed(&value, sizeof value, value_); }

void StateHash::add(std::string_view text) {
  value_ = XXH3_64bits_withSeed(text.data(), text.size(), value_);
}

void StateHash::add(const WorldState& state) {
  add(static_cast<std::uint64_t>(state.tick));
  // Without the numbers of items, values could move from one list to another unseen.
  add(std::uint64_t{state.robots.size()});
  add(std::uint64_t{state.balls.size()});
  add(std::uint64_t{state.obstacles.size()});
  for (const RobotState& robot : state.robots) {
    addVec(*this, robot.pose.position);
    add(robot.pose.heading);
    addVec(*this, robot.velocity);
    add(robot.angular_velocity);
    add(robot.wheels.left);
    add(robot.wheels.right);
  }
  for (const BallState& ball : state.balls) {
    addVec(*this, ball.position);
    addVec(*this, ball.velocity);
    addVec(*this, ball.spin);
  }
  for (const ObstacleState& obstacle : state.obstacles) {
    addVec(*this, obstacle.pose.position);
    add(obstacle.pose.heading);
    addVec(*this, obstacle.velocity);
  }
}

}  // namespace fulbito
