#include <memory>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/striker/wall_scene.hpp"

namespace fulbito {
namespace {

using test::kDown, test::kUp, test::WallScene;

/// A ball at the wall of their half, with a robot of `firasim` at it and an opponent on its other side.
WallScene duel(double side) {
  const Vec2 ball{0.3, 0.628}, off{-0.055, -0.024};
  WallScene scene(ball, ball + off, ball + Vec2{0.045, -0.06}, side);
  scene.pitch = libero::Pitch(test::infoOf(3, "firasim"));
  scene.seen.own[0].state.pose.heading = side * math::angleOf(-off);
  scene.free_balls_pay = true;
  return scene;
}

/// A libero to which two free balls of their half have brought nothing before.
class Discouraged final : public Strategy {
 public:
  void begin(const MatchInfo& info) override {
    libero_->begin(info);
    Observation past;
    past.team_size = info.rules.team_size;
    past.since_restart = 20.0;
    libero_->decide(past);
    past.restart = RestartKind::kFreeBall;
    past.restart_is_ours = true;
    for (int taken = 0; taken < 2; ++taken) {
      for (const double since : {0.0, 20.0}) {
        past.since_restart = since;
        libero_->decide(past);
      }
    }
  }
  TeamCommand decide(const Observation& observation) override { return libero_->decide(observation); }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    return libero_->place(request);
  }

 private:
  std::unique_ptr<Strategy> libero_ = *makeTeam(*parseTeam("libero:without=withdraw"));
};

}  // namespace

TEST_CASE("where nobody can shove, libero holds a ball at a wall of their half for the free ball", "[unit]") {
  for (const double side : {kUp, kDown}) {
    const auto holds = [](const WallScene& scene) { return scene.move(libero::striker::hold).has_value(); };
    const auto move = duel(side).move(libero::striker::hold);
    REQUIRE(move);
    CHECK(std::abs(move->twist.angular) < 1e-6);  // straight at the ball
    CHECK(std::abs(move->twist.linear) < 0.05);   // a push would creep
    WallScene other = duel(side);
    other.free_balls_pay = false;
    CHECK_FALSE(holds(other));
    other = duel(side);
    other.pitch = libero::Pitch(test::infoOf(3, "vsss"));
    CHECK_FALSE(holds(other));
    other = duel(side);
    for (Vec2* place : {&other.seen.ball.position, &other.seen.own[0].state.pose.position,
                        &other.seen.opponents[0].state.pose.position})
      place->x -= 0.6;
    other.forecast.take(other.seen.ball, {});
    CHECK_FALSE(holds(other));  // in our half
  }
}

TEST_CASE("libero holds no ball for a free ball that nobody gives", "[unit]") {
  WallScene late = duel(kUp);
  late.stuck = 15.0;
  CHECK_FALSE(late.move(libero::striker::hold));
  WallScene never = duel(kUp);
  MatchInfo info = test::infoOf(3, "firasim");
  info.rules.stuck.seconds = 600.0;
  never.pitch = libero::Pitch(info);
  CHECK_FALSE(never.move(libero::striker::hold));
}

TEST_CASE("libero holds a ball against an opponent that pushes, as long as free balls pay", "[unit]") {
  MatchConfig config = test::matchOf("libero", "chaser", "vsss-3v3", 20.0);
  config.robot = *loadRobot("firasim");
  Placement scene;
  scene.ball = {0.3, 0.628};
  scene.robots[0][1] = Pose2{{0.245, 0.604}, 0.41};
  scene.robots[1][1] = Pose2{{0.355, 0.604}, 2.73};
  // How far [m] the ball is from its place just before the free ball.
  const auto moved = [&](const TeamChoice& team, double side) {
    config.teams[0] = team;
    Match match = test::matchFrom(config, test::mirrored(scene, side));
    while (match.seconds() < config.rules.stuck.seconds - 1.0 && match.step()) {
    }
    return distance(match.world().balls[0].position, test::onSide(scene.ball, side));
  };
  const TeamChoice discouraged =
      TeamChoice::own("discouraged", [] { return std::make_unique<Discouraged>(); });
  for (const double side : {kUp, kDown}) {
    CHECK(moved(*parseTeam("libero:without=withdraw"), side) < config.rules.stuck.radius);
    CHECK(moved(discouraged, side) > config.rules.stuck.radius);
  }
}

}  // namespace fulbito
