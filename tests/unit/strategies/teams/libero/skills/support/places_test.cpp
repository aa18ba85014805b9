#include "engine/core/math/random.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/playbook/playbook.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's robots without the ball have places on the field, off the ball, in no area", "[unit]") {
  for (const int size : {3, 5}) {
    const MatchInfo info = test::infoOf(size);
    const libero::Pitch pitch(info);
    const auto play_book = libero::PlayBook::without("block+join");
    REQUIRE(play_book);
    Rng rng(7, test::kTestStream, static_cast<std::uint64_t>(size));
    for (int run = 0; run < 2000; ++run) {
      Observation seen = test::anything(rng, info);
      seen.ball.velocity = {};
      libero::BallForecast ball;
      ball.take(seen.ball, {});
      libero::Picture picture{seen, pitch, ball};
      picture.keeper = 0;
      for (int robot = 1; robot < size; ++robot) {
        CAPTURE(size, run, robot, seen.ball.position.x, seen.ball.position.y);
        picture.rank[static_cast<std::size_t>(robot)] = robot - 1;
        libero::Memory memory;
        const Vec2 place =
            play_book->decide(libero::Role::kSupport, picture, robot, memory).place.value_or(Vec2{});
        CHECK(wallClearance(info.field, place) > pitch.robot_half);
        CHECK_FALSE(isInArea(info.field, place, true, pitch.touch - 1e-9));
        const bool in_theirs = isInArea(info.field, seen.ball.position, false);
        if (in_theirs) CHECK_FALSE(isInArea(info.field, place, false, pitch.touch - 1e-9));
        // At the edge of an area there may be no room beside the ball.
        const bool room = distanceToArea(info.field, seen.ball.position, true) > 0.35 &&
                          distanceToArea(info.field, seen.ball.position, false) > 0.35;
        if (room) CHECK(distance(place, seen.ball.position) > 0.15);
      }
    }
  }
}

}  // namespace fulbito
