#include "tournament/book/draw_order.hpp"

#include <array>
#include <numeric>
#include <utility>

#include "engine/core/math/random.hpp"

namespace fulbito {
namespace {

constexpr int kKindShift = 56;

}  // namespace

std::uint64_t drawIndex(StartKind kind, std::uint64_t number) {
  return (static_cast<std::uint64_t>(kind) << kKindShift) + number;
}

std::size_t caseOf(const StartKey& key, std::size_t count) {
  std::array<std::size_t, 8> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  Rng rng(key.seed, Stream::kStartBook, drawIndex(key.kind, key.turn / count));
  for (std::size_t left = count; left > 1; --left) {
    std::swap(order[left - 1], order[rng.below(static_cast<std::uint32_t>(left))]);
  }
  return order[key.turn % count];
}

}  // namespace fulbito
