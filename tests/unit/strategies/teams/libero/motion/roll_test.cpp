#include "strategies/teams/libero/motion/roll.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("a braking robot keeps within its bounds", "[unit]") {
  for (const char* robot : {"vsss", "firasim", "choi-lee-2005", "jung-lee-2015"}) {
    const libero::Pitch pitch(test::infoOf(3, robot));
    Rng rng(1, test::kTestStream);
    for (int run = 0; run < 2000; ++run) {
      // All speeds that its rims allow, pushed or not.
      const double yaw = rng.uniform(-pitch.speed, pitch.speed), rest = pitch.speed - std::abs(yaw);
      RobotState state;
      state.velocity.x = rng.uniform(-rest, rest);
      state.velocity.y = run % 2 == 0 ? 0.0 : rng.uniform(-0.5, 0.5);
      state.angular_velocity = yaw / pitch.half_track;
      libero::Roll roll(pitch, state);
      const libero::Roll start = roll;
      CAPTURE(robot, state.velocity, yaw);
      for (int tick = 1; tick <= pitch.ticks_to_rest; ++tick) {
        roll.brake();
        const double time = tick * pitch.tick, turned = std::abs(math::angleOf(roll.face));
        constexpr double kRounding = 1e-6;  // [m] of `smallTurn`, in many ticks
        REQUIRE(distance(roll.place, start.place) <= start.mostDriven(time) + kRounding);
        // Beyond half a turn the angle is not known.
        const double turns = start.mostTurned(time) / pitch.half_track;
        if (turns < math::kPi) REQUIRE(turned <= turns + kRounding / pitch.half_track);
      }
    }
  }
}

}  // namespace fulbito
