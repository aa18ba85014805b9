#include <cstdint>
#include <functional>
#include <set>
#include <string_view>
#include <vector>

#include "fulbito/detail/state_hash.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

template <typename... Values>
std::uint64_t hashOf(Values... values) {
  StateHash hash;
  (hash.add(values), ...);
  return hash.value();
}

WorldState sampleState() {
  WorldState state;
  state.tick = 42;
  state.robots = {{{{0.1, -0.2}, 0.3}, {0.4, 0.5}, -0.6, {7.0, 8.0}}, {}};
  state.balls = {{{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}};
  state.obstacles = {{{{-1.0, -2.0}, 0.25}, {0.125, 0.0}}};
  return state;
}

TEST_CASE("both zeros hash alike, neighbouring doubles do not", "[unit]") {
  CHECK(hashOf(-0.0) == hashOf(0.0));
  CHECK(hashOf(0.0) != hashOf(0x1p-1074));
  CHECK(hashOf(1.0) != hashOf(0x1.0000000000001p0));
  CHECK(hashOf(1.0) != hashOf(-1.0));
}

TEST_CASE("the order and the number of values matter", "[unit]") {
  CHECK(hashOf(1.0, 2.0) != hashOf(2.0, 1.0));
  CHECK(hashOf(0.0) != hashOf(0.0, 0.0));
  CHECK(hashOf(0.0) != StateHash().value());
}

TEST_CASE("texts hash by their letters and where they are cut", "[unit]") {
  using std::string_view;
  CHECK(hashOf(string_view("ab"), string_view("c")) != hashOf(string_view("a"), string_view("bc")));
  CHECK(hashOf(string_view("ab"), string_view("")) != hashOf(string_view("ab")));
  CHECK(hashOf(string_view("robot")) == hashOf(string_view("robots").substr(0, 5)));
}

TEST_CASE("hashes never change", "[unit]") {
  CHECK(hashOf(1.5, -0.25) == 0xde7ed9005d1e429au);
  CHECK(hashOf(std::string_view("fulbito")) == 0xa53abadeb9b4fa98u);  // as `xxhsum -H3` prints
  CHECK(hashOf(sampleState()) == 0x8bb2555c747d04bcu);
}

TEST_CASE("every field of the world's state changes its hash", "[unit]") {
  const std::vector<std::function<void(WorldState&)>> changes = {
      [](WorldState& s) { ++s.tick; },
      [](WorldState& s) { s.robots[0].pose.position.x += 1.0; },
      [](WorldState& s) { s.robots[0].pose.position.y += 1.0; },
      [](WorldState& s) { s.robots[0].pose.heading += 1.0; },
      [](WorldState& s) { s.robots[0].velocity.x += 1.0; },
      [](WorldState& s) { s.robots[0].velocity.y += 1.0; },
      [](WorldState& s) { s.robots[0].angular_velocity += 1.0; },
      [](WorldState& s) { s.robots[0].wheels.left += 1.0; },
      [](WorldState& s) { s.robots[1].wheels.right += 1.0; },
      [](WorldState& s) { s.balls[0].position.x += 1.0; },
      [](WorldState& s) { s.balls[0].position.y += 1.0; },
      [](WorldState& s) { s.balls[0].velocity.x += 1.0; },
      [](WorldState& s) { s.balls[0].velocity.y += 1.0; },
      [](WorldState& s) { s.balls[0].spin.x += 1.0; },
      [](WorldState& s) { s.balls[0].spin.y += 1.0; },
      [](WorldState& s) { s.obstacles[0].pose.position.x += 1.0; },
      [](WorldState& s) { s.obstacles[0].pose.position.y += 1.0; },
      [](WorldState& s) { s.obstacles[0].pose.heading += 1.0; },
      [](WorldState& s) { s.obstacles[0].velocity.x += 1.0; },
      [](WorldState& s) { s.obstacles[0].velocity.y += 1.0; },
      [](WorldState& s) { s.robots.pop_back(); },
      [](WorldState& s) { s.balls.clear(); },
      [](WorldState& s) { s.obstacles.clear(); },
  };
  std::set<std::uint64_t> seen = {hashOf(sampleState())};
  for (const auto& change : changes) {
    WorldState state = sampleState();
    change(state);
    seen.insert(hashOf(state));
  }
  CHECK(seen.size() == changes.size() + 1);
}

TEST_CASE("items moved to another list change the hash though the numbers stay the same", "[unit]") {
  WorldState robots, balls;
  robots.robots.resize(3);  // the same 24 zeros as hashed bytes
  balls.balls.resize(4);
  CHECK(hashOf(robots) != hashOf(balls));
}

TEST_CASE("a hash goes on from the value of another", "[unit]") {
  StateHash whole;
  whole.add(1.5);
  StateHash rest(whole.value());
  whole.add(2.5);
  rest.add(2.5);
  CHECK(rest.value() == whole.value());
}

}  // namespace
}  // namespace fulbito
