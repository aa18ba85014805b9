#include "strategies/skills/role_assignment.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace fulbito {
namespace {

using Costs = RoleAssignment::Costs;
using Roles = std::array<int, kMaxTeamSize>;

double costOf(const Costs& costs, const Roles& roles, int count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    sum += costs[i][static_cast<std::size_t>(roles[i])];
  }
  return sum;
}

/// Tries all orders: for up to six robots cheaper than anything clever.
struct Search {
  const Costs& costs;
  int count;
  Roles roles{};
  Roles best{};
  double least = std::numeric_limits<double>::infinity();

  void run(int robot, unsigned used, double sum) {
    if (sum >= least) return;
    if (robot == count) {
      least = sum, best = roles;
      return;
    }
    for (int role = 0; role < count; ++role) {
      if ((used >> role & 1U) != 0) continue;
      const auto r = static_cast<std::size_t>(robot);
      roles[r] = role;
      run(robot + 1, used | 1U << role, sum + costs[r][static_cast<std::size_t>(role)]);
    }
  }
};

/// Exchanges pairs as long as that helps.
Roles improved(const Costs& costs, int count, Roles roles) {
  for (bool better = true; better;) {
    better = false;
    for (std::size_t a = 0; a < static_cast<std::size_t>(count); ++a) {
      for (std::size_t b = a + 1; b < static_cast<std::size_t>(count); ++b) {
        const auto ra = static_cast<std::size_t>(roles[a]), rb = static_cast<std::size_t>(roles[b]);
        if (costs[a][rb] + costs[b][ra] + 1e-9 >= costs[a][ra] + costs[b][rb]) continue;
        std::swap(roles[a], roles[b]);
        better = true;
      }
    }
  }
  return roles;
}

Roles bestRoles(const Costs& costs, int count, const Roles& present) {
  constexpr int kMostTried = 6;
  if (count > kMostTried) return improved(costs, count, present);
  Search search{costs, count};
  search.run(0, 0U, 0.0);
  return search.best;
}

}  // namespace

std::span<const int> RoleAssignment::assign(const Costs& costs, int count, double dt, bool event) {
  since_change_ += dt;
  if (!known_ || count != count_) {
    for (int i = 0; i < count; ++i) roles_[static_cast<std::size_t>(i)] = i;
    roles_ = bestRoles(costs, count, roles_);
    known_ = true;
    count_ = count;
    since_change_ = 1e9;
    return {roles_.data(), static_cast<std::size_t>(count)};
  }
  if (event || since_change_ >= settings_.dwell) {
    const Roles best = bestRoles(costs, count, roles_);
    const double fresh = std::max(0.0, 1.0 - since_change_ / settings_.settling);
    const double margin = settings_.margin + (event ? 0.0 : settings_.fresh_margin * fresh);
    if (costOf(costs, best, count) < costOf(costs, roles_, count) - margin) {
      roles_ = best;
      since_change_ = 0.0;
      ++changes_;
    }
  }
  return {roles_.data(), static_cast<std::size_t>(count)};
}

std::size_t RoleAssignment::robotWith(int role) const {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    if (roles_[i] == role) return i;
  }
  return 0;
}

}  // namespace fulbito
