#include <set>
#include <tuple>

#include "tests/support/catch.hpp"
#include "tournament/book/book.hpp"

namespace fulbito {

TEST_CASE("10,000 states from play of three shards: all differ", "[soak]") {
  constexpr std::size_t kStarts = 10000;
  const BookConfig book{{StartKind::kPlay}, 1};
  const auto match = MatchConfig::standard("idle", "idle");
  REQUIRE(match);
  std::set<std::tuple<double, double, double, double>> states;
  for (std::size_t shard = 0; shard < 3; ++shard) {
    for (std::size_t i = shard; i < kStarts; i += 3) {
      MatchConfig started = *match;
      REQUIRE(applyStart(book, i, started));
      const Placement& placed = *started.start;
      states.insert({placed.ball.x, placed.ball.y, placed.ball_velocity.x, placed.ball_velocity.y});
    }
  }
  CHECK(states.size() == kStarts);
}

}  // namespace fulbito
