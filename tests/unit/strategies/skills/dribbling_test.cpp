#include "strategies/skills/dribbling.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("an opponent dribbles at the goal if it pushes the ball there from behind", "[unit]") {
  const auto dribbles = [](Vec2 opponent, Vec2 velocity) {
    Observation seen;
    seen.opponents[1].present = true;
    seen.opponents[1].state.pose.position = opponent;
    return opponentDribblesAtGoal(seen, {{0.0, 0.0}, velocity, {}});
  };
  CHECK(dribbles({0.07, 0.0}, {-0.5, 0.2}));
  CHECK_FALSE(dribbles({-0.07, 0.0}, {-0.5, 0.2}));  // it is in the ball's way
  CHECK_FALSE(dribbles({0.20, 0.0}, {-0.5, 0.2}));   // it has only kicked the ball
  CHECK_FALSE(dribbles({0.07, 0.0}, {-0.2, 0.5}));   // the ball goes aside
}

}  // namespace fulbito
