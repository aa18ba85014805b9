#include "match/report/play_counter.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr Vec2 kAway{0.3, 0.3};  // a place without walls

/// Two robots of blue, which defends the left goal, and one of yellow. The test moves them.
struct Scene {
  MatchConfig config;
  MatchStatistics counted;
  WorldState world;
  RefereeState referee;
  std::vector<RobotId> ids{{TeamId::kBlue, 0}, {TeamId::kYellow, 0}, {TeamId::kBlue, 2}};
  std::vector<ContactEvent> contacts;
  PlayCounter counter{config};
  Tick tick = 0;

  Scene() {
    world.robots.resize(ids.size());
    world.balls.resize(1);
    world.balls[0].position = kAway;
    for (RobotState& robot : world.robots) robot.velocity = {0.5, 0.0};
    world.robots[0].pose.position = {-0.7, 0.0};
    world.robots[1].pose.position = {0.7, 0.0};
  }
  void step(int ticks = 1, bool touching = false) {
    for (int i = 0; i < ticks; ++i) {
      if (touching) contacts = {{{BodyKind::kRobot, 0}, {BodyKind::kRobot, 2}, {}, {}, 0.1, false}};
      MatchTick now;
      now.tick = ++tick;
      now.ids = ids;
      now.world = &world;
      now.contacts = contacts;
      now.referee = &referee;
      counter.count(now, counted);
      contacts.clear();
    }
  }
  /// Whether the ball counts at `place`: at a wall, in a corner.
  std::pair<bool, bool> at(Vec2 place) {
    const Tick wall = counted.wall_ticks, corner = counted.corner_ticks;
    world.balls[0].position = place;
    step();
    return {counted.wall_ticks > wall, counted.corner_ticks > corner};
  }
  void speed(double value) {
    for (RobotState& robot : world.robots) robot.velocity = {0.0, value};
  }
  const TeamPlay& blue() const { return counted.teams[0].play; }
};

using BallAt = std::pair<bool, bool>;

}  // namespace

TEST_CASE("a ball is at a wall up to a gap of 5 cm, and in a corner up to 15 cm from both lines", "[unit]") {
  Scene scene;
  const double near = kWallGap + scene.config.robot.ball.radius;  // of its centre
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const auto from = [&](double end, double side) {
        return scene.at({x * (0.75 - end), y * (0.65 - side)});
      };
      CHECK(from(0.4, near - 1e-6) == BallAt{true, false});
      CHECK(from(0.4, near + 1e-6) == BallAt{false, false});
      CHECK(from(near - 1e-6, 0.4) == BallAt{true, false});
      CHECK(from(near + 1e-6, 0.4) == BallAt{false, false});
      CHECK(from(0.149, 0.149) == BallAt{false, true});
      CHECK(from(0.151, 0.149) == BallAt{false, false});
      CHECK(from(0.08, 0.08) == BallAt{true, true});  // 6.4 cm from the triangle's wall
    }
  }
  CHECK(scene.at({0.74, 0.0}) == BallAt{false, false});  // in front of the mouth there is no wall
  CHECK(scene.at({0.74, 0.2 - near}) == BallAt{false, false});
  CHECK(scene.at({0.74, 0.2 - near + 0.01}) == BallAt{true, false});  // at the post
}

TEST_CASE("a field without corner triangles has square corners", "[unit]") {
  Scene scene;
  scene.config.field.corner = 0.0;
  scene.counter = PlayCounter(scene.config);
  CHECK(scene.at({0.65, 0.55}) == BallAt{false, true});
  CHECK(scene.at({0.69, 0.55}) == BallAt{true, true});
}

TEST_CASE("slow robots are counted with and without the keeper", "[unit]") {
  Scene scene;
  scene.world.robots[0].velocity = {0.03, 0.03};  // the keeper
  scene.step(4);
  CHECK(scene.blue().slow() == Approx(0.5));
  CHECK(scene.blue().fieldSlow() == 0.0);
  scene.world.robots[2].velocity = {0.0, -0.049};
  scene.step(4);
  CHECK(scene.blue().slow() == Approx(0.75));
  CHECK(scene.blue().fieldSlow() == Approx(0.5));
  scene.world.robots[2].pose.position = {-0.74, 0.0};  // now this one is the keeper
  scene.world.robots[0].velocity = {0.051, 0.0};
  scene.step(8);
  CHECK(scene.blue().fieldSlow() == Approx(0.25));
  CHECK(scene.counted.teams[1].play.field_ticks == 0);  // yellow has a keeper only
  CHECK(scene.counted.teams[1].play.fieldSlow() == 0.0);
}

TEST_CASE("the keeper is away if no robot is within 30 cm of the goal while the ball is in the own half",
          "[unit]") {
  Scene scene;
  scene.world.robots[0].pose.position = {-0.4, 0.0};
  scene.step(5);
  CHECK(scene.blue().own_half == 0);
  scene.world.balls[0].position = {-0.1, 0.2};
  scene.step(3);
  CHECK(scene.blue().keeperAway() == 1.0);
  scene.world.robots[2].pose.position = {-0.6, 0.25};  // 29 cm from the goal
  scene.step(3);
  CHECK(scene.blue().keeperAway() == Approx(0.5));
  CHECK(scene.counted.teams[1].play.own_half == 5);
  scene.referee.blue_side = Side::kRight;
  scene.step(5);
  CHECK(scene.blue().own_half == 6);
}

TEST_CASE("nobody is behind the ball if no robot is nearer to the own goal line", "[unit]") {
  Scene scene;
  scene.counted.play_ticks = 4;
  scene.world.robots[2].pose.position = {0.4, 0.0};
  scene.step(2);
  CHECK(scene.blue().uncovered == 0);
  CHECK(scene.blue().field_uncovered == 2);
  scene.world.robots[0].pose.position = {0.35, 0.0};  // ahead of the ball, but nearest to the goal
  scene.step(2);
  CHECK(scene.counted.uncovered(TeamId::kBlue) == Approx(0.5));
  CHECK(scene.counted.fieldUncovered(TeamId::kBlue) == Approx(1.0));
  CHECK(scene.counted.uncovered(TeamId::kYellow) == 0.0);
}

TEST_CASE("two slow teammates in contact lock each other once, after 1.5 s", "[unit]") {
  Scene scene;
  scene.speed(0.11);
  scene.step(90, true);  // 60 ticks per second
  CHECK(scene.blue().locks == 0);
  scene.step(1, true);
  CHECK(scene.blue().locks == 1);
  scene.step(6);  // a pause of 0.1 s
  scene.step(200, true);
  CHECK(scene.blue().locks == 1);
  CHECK(scene.blue().longest_contact == 297);
  scene.step(7);
  scene.step(91, true);
  CHECK(scene.blue().locks == 2);
  CHECK(scene.blue().longest_contact == 297);
}

TEST_CASE("fast teammates in contact do not lock each other", "[unit]") {
  Scene scene;
  scene.speed(0.11);
  scene.world.robots[2].velocity = {0.13, 0.0};
  scene.step(30, true);
  CHECK(scene.blue().long_contacts == 0);
  scene.step(170, true);
  CHECK(scene.blue().long_contacts == 1);
  CHECK(scene.blue().locks == 0);
  CHECK(scene.blue().longest_contact == 200);
}

TEST_CASE("a contact ends with the play; opponents in contact do not count", "[unit]") {
  Scene scene;
  scene.speed(0.0);
  scene.step(60, true);
  scene.counter.begin();
  scene.step(60, true);
  CHECK(scene.blue().locks == 0);
  CHECK(scene.blue().longest_contact == 60);
  for (int i = 0; i < 200; ++i) {
    scene.contacts = {{{BodyKind::kRobot, 0}, {BodyKind::kRobot, 1}, {}, {}, 0.1, false}};
    scene.step();
  }
  CHECK(scene.blue().longest_contact == 60);
}

}  // namespace fulbito
