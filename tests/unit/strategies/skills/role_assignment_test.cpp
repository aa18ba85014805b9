#include "strategies/skills/role_assignment.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

using Costs = RoleAssignment::Costs;

double costOf(const Costs& costs, std::span<const int> roles) {
  double sum = 0.0;
  for (std::size_t i = 0; i < roles.size(); ++i) sum += costs[i][static_cast<std::size_t>(roles[i])];
  return sum;
}

Costs randomCosts(Rng& rng, std::size_t count) {
  Costs costs{};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count; ++k) costs[i][k] = rng.uniform(0.0, 3.0);
  }
  return costs;
}

}  // namespace

TEST_CASE("the first assignment is the cheapest of all", "[unit]") {
  Rng rng(1, Stream::kTest);
  for (int count = 1; count <= 5; ++count) {
    for (int i = 0; i < 50; ++i) {
      const Costs costs = randomCosts(rng, static_cast<std::size_t>(count));
      RoleAssignment roles;
      const double cost = costOf(costs, roles.assign(costs, count, 0.0, false));
      std::vector<int> order(static_cast<std::size_t>(count));
      std::iota(order.begin(), order.end(), 0);
      do {
        CHECK(cost <= costOf(costs, order) + 1e-12);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

TEST_CASE("large teams get each role once", "[unit]") {
  Rng rng(2, Stream::kTest);
  const Costs costs = randomCosts(rng, 11);
  RoleAssignment roles;
  const auto given = roles.assign(costs, 11, 0.0, false);
  std::vector<int> sorted(given.begin(), given.end());
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < 11; ++i) CHECK(sorted[static_cast<std::size_t>(i)] == i);
  CHECK(roles.roleOf(roles.robotWith(7)) == 7);
}

TEST_CASE("roles do not flap", "[unit]") {
  // Two robots whose costs wander around each other, with noise: the cheaper one changes often.
  constexpr double kDt = 1.0 / 60.0;
  Rng rng(3, Stream::kTest);
  RoleAssignment roles;
  double difference = 0.0, last_change = -1.0;
  int crossings = 0, before = 0;
  bool was_cheaper = true;
  for (int tick = 0; tick < 60 * 120; ++tick) {
    difference += 0.06 * rng.normal() - 0.02 * difference;
    Costs costs{};
    const double noise = 0.03 * rng.normal();
    costs[0][0] = 1.0 + difference + noise, costs[1][0] = 1.0;
    roles.assign(costs, 2, kDt, false);
    crossings += (costs[0][0] < costs[1][0]) != was_cheaper;
    was_cheaper = costs[0][0] < costs[1][0];
    if (roles.changes() != before) {
      before = roles.changes();
      const double now = tick * kDt;
      CHECK(now - last_change > 0.3);
      last_change = now;
    }
  }
  CAPTURE(crossings);
  CHECK(crossings > 500);
  CHECK(roles.changes() > 2);
  CHECK(roles.changes() <= 60);  // 0.5 a second, the bar of drill 19
}

TEST_CASE("an event changes roles at once, but not for nothing", "[unit]") {
  RoleAssignment roles;
  Costs costs{};
  costs[0][0] = 1.0, costs[1][0] = 2.0;
  CHECK(roles.assign(costs, 2, 0.1, false)[0] == 0);
  costs[0][0] = 3.0;
  CHECK(roles.assign(costs, 2, 0.1, false)[0] == 1);
  costs[0][0] = 1.0;
  CHECK(roles.assign(costs, 2, 0.1, false)[0] == 1);  // within the dwell time
  CHECK(roles.assign(costs, 2, 0.1, true)[0] == 0);
  costs[0][0] = 2.1;
  CHECK(roles.assign(costs, 2, 9.0, true)[0] == 0);  // better by less than the margin
}

}  // namespace fulbito
