#include <bit>

#include "fulbito/detail/state_hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace fulbito {
namespace {

/// A running hash in a register: a match adds about sixty numbers per tick, and calls would cost as much as
/// the hashing.
class Chain {
 public:
  explicit Chain(std::uint64_t value) : value_(value) {}
  void add(std::uint64_t value) { value_ = XXH3_64bits_withSeed(&value, sizeof value, value_); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
  void add(Vec2 v) {
    add(v.x);
    add(v.y);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace

void StateHash::add(double value) {
  Chain chain(value_);
  chain.add(value);
  value_ = chain.value();
}

void StateHash::add(std::uint64_t value) {
  Chain chain(value_);
  chain.add(value);
  value_ = chain.value();
}

void StateHash::add(std::string_view text) {
  value_ = XXH3_64bits_withSeed(text.data(), text.size(), value_);
}

// `flatten` inlines xxHash, so that the fixed length of a number selects its branch at compile time.
[[gnu::flatten]] void StateHash::add(const WorldState& state) {
  Chain chain(value_);
  chain.add(static_cast<std::uint64_t>(state.tick));
  // Without the lengths of the lists, a value that moves between lists would not change the hash.
  chain.add(std::uint64_t{state.robots.size()});
  chain.add(std::uint64_t{state.balls.size()});
  chain.add(std::uint64_t{state.obstacles.size()});
  for (const RobotState& robot : state.robots) {
    chain.add(robot.pose.position);
    chain.add(robot.pose.heading);
    chain.add(robot.velocity);
    chain.add(robot.angular_velocity);
    chain.add(robot.wheels.left);
    chain.add(robot.wheels.right);
  }
  for (const BallState& ball : state.balls) {
    chain.add(ball.position);
    chain.add(ball.velocity);
    chain.add(ball.spin);
  }
  for (const ObstacleState& obstacle : state.obstacles) {
    chain.add(obstacle.pose.position);
    chain.add(obstacle.pose.heading);
    chain.add(obstacle.velocity);
  }
  // Only added if there are rods: the hashes of worlds without them do not depend on this field.
  if (!state.rods.empty()) chain.add(std::uint64_t{state.rods.size()});
  for (const RodState& rod : state.rods) {
    chain.add(rod.pose.position);
    chain.add(rod.pose.heading);
    chain.add(rod.velocity);
    chain.add(rod.angular_velocity);
    for (const Vec2 force : rod.forces) chain.add(force);
  }
  value_ = chain.value();
}

}  // namespace fulbito
