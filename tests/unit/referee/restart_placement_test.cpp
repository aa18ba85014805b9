#include "referee/restart_placement.hpp"

#include "engine/core/presets.hpp"
#include "engine/core/random.hpp"
#include "referee/restart_call.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr RestartKind kKinds[] = {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                  RestartKind::kPenalty, RestartKind::kGoalKick};

RefereeSetup setupOf(const std::string& profile) {
  RefereeSetup setup;
  setup.rules = *loadRules(profile);
  setup.field = *loadField(setup.rules.field);
  const RobotPreset robot = *loadRobot("vsss");
  setup.robot = robot.robot;
  setup.ball = robot.ball;
  return setup;
}

std::string reasonOf(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                     const Placement& placement) {
  const auto flaw = findPlacementFlaw(setup, state, call, placement);
  if (!flaw) return "";
  return std::string(nameOf(call.kind)) + " for " + nameOf(call.team) + ": " + nameOf(flaw->team) + " " +
         std::to_string(flaw->robot) + " " + std::string(flaw->reason);
}

}  // namespace

TEST_CASE("the tables place every restart legally, for both teams and both sides", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021", "training"}) {
    const RefereeSetup setup = setupOf(profile);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      RefereeState state;
      state.blue_side = side;
      for (const RestartKind kind : kKinds) {
        for (const TeamId team : kTeams) {
          for (const Vec2 ball : {Vec2{0.3, 0.3}, Vec2{-0.3, 0.3}, Vec2{-0.3, -0.3}, Vec2{0.3, -0.3}}) {
            const RestartCall call = makeCall(setup, state, {kind, team, ball, nullptr});
            CHECK(reasonOf(setup, state, call, call.defaults) == "");
            std::vector<GameEvent> log;
            const Placement placement = place(setup, state, call, {}, log);
            CHECK(reasonOf(setup, state, call, placement) == "");
            CHECK(log.empty());
            for (const TeamId t : kTeams) {
              for (int n = 0; n < setup.rules.team_size; ++n) {
                const auto& pose = placement.robots[indexOf(t)][static_cast<std::size_t>(n)];
                REQUIRE(pose);
                const auto& own = defaultPoses(call, t)[static_cast<std::size_t>(n)];
                CHECK(pose->position == own->position);
              }
            }
          }
        }
      }
    }
  }
}

}  // namespace fulbito
