#include "referee/trial/trial_referee.hpp"

#include <numbers>

#include "engine/core/models/shapes.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kDt = 1.0 / 60.0;

/// A robot that the test moves along +x, as the referee sees it.
struct Drive {
  Layout layout;
  FieldGeometry field;
  RobotModel robot;
  TrialRules rules;
  WorldState world;

  Drive() {
    layout.start = {{-0.5, 0.0}, 0.0};
    layout.goal = {0.5, 0.0};
    layout.obstacles.emplace_back().pose = {{0.0, 0.3}, 0.0};
    rules.length_limit = 1.0;
    rules.time_limit = timeBound(1.0, 1.0, 5.0);
    world.robots.resize(1);
    world.robots[0].pose = layout.start;
    world.obstacles.resize(1);
    world.obstacles[0].pose = layout.obstacles[0].pose;
  }
  bool advance(TrialReferee& referee, Vec2 velocity, std::vector<ContactEvent> contacts = {}) {
    world.robots[0].velocity = velocity;
    world.robots[0].pose.position += velocity * kDt;
    return referee.observe(world, contacts, {});
  }
  TrialScore run(Vec2 velocity, std::vector<ContactEvent> first = {}) {
    TrialReferee referee(layout, field, robot, rules, kDt);
    bool over = advance(referee, velocity, std::move(first));
    for (int i = 0; i < 2000 && !over; ++i) over = advance(referee, velocity);
    REQUIRE(over);
    return referee.score();
  }
};

}  // namespace

TEST_CASE("the time bound is a ramp and a run, or a ramp alone", "[unit]") {
  CHECK(timeBound(1.0, 1.0, 5.0) == Approx(1.1));
  CHECK(timeBound(0.5, 2.6, 5.0) == Approx(std::sqrt(0.2)));
  // Both forms agree where the ramp just reaches the top speed.
  CHECK(timeBound(0.1, 1.0, 5.0) == Approx(std::sqrt(0.04)));
  // Choi & Lee (2005), Table 4: d = 7.18 m, a = 0.05 m/s^2, v = 0.1 ... 0.5 m/s, printed 72.8 ... 19.3 s
  // (truncated).
  CHECK(timeBound(7.18, 0.1, 0.05) == Approx(72.8));
  CHECK(timeBound(7.18, 0.5, 0.05) == Approx(19.36));
}

TEST_CASE("arrival is interpolated within the tick", "[unit]") {
  Drive drive;
  const TrialScore score = drive.run({1.0, 0.0});
  CHECK(score.outcome == TrialOutcome::kReached);
  CHECK(score.arrived);
  CHECK(score.time == Approx(0.97).epsilon(1e-9));
  CHECK(score.length == Approx(0.97).epsilon(1e-9));
}

TEST_CASE("a robot that crosses the goal within one tick has arrived", "[unit]") {
  Drive drive;
  drive.layout.goal_tolerance = 0.001;
  const TrialScore score = drive.run({2.6, 0.0});
  CHECK(score.success());
  CHECK(score.length == Approx(0.999).epsilon(1e-6));
}

TEST_CASE("arrival with the wrong heading does not count where a heading is wanted", "[unit]") {
  Drive drive;
  drive.layout.goal_heading = 1.0;
  CHECK(drive.run({1.0, 0.0}).outcome != TrialOutcome::kReached);
  drive.layout.goal_heading = 0.1;
  const TrialScore score = drive.run({1.0, 0.0});
  CHECK(score.outcome == TrialOutcome::kReached);
  CHECK(score.heading_error == Approx(0.1));
}

TEST_CASE("a robot that turns in the goal has arrived when its heading comes right, not a tick earlier",
          "[unit]") {
  Drive drive;
  drive.layout.goal_heading = 1.0;
  drive.layout.heading_tolerance = 0.1;
  drive.world.robots[0].pose.position = {0.49, 0.0};
  TrialReferee referee(drive.layout, drive.field, drive.robot, drive.rules, kDt);
  CHECK_FALSE(drive.advance(referee, {0.06, 0.0}));  // in the circle, looking elsewhere
  const double length = referee.score().length;
  drive.world.robots[0].pose.heading = 1.0;
  CHECK(drive.advance(referee, {0.06, 0.0}));
  CHECK(referee.score().time == Approx(2 * kDt));
  CHECK(referee.score().length == Approx(length + 0.06 * kDt));
}

TEST_CASE("a contact spoils a trial as its rules say", "[unit]") {
  Drive drive;
  const ContactEvent wall{{BodyKind::kWall, 0}, {BodyKind::kRobot, 0}, {-0.6, 0.0}, {1.0, 0.0}, 0.02, true};
  const ContactEvent obstacle{
      {BodyKind::kRobot, 0}, {BodyKind::kObstacle, 0}, {-0.6, 0.0}, {-1.0, 0.0}, 0.03, true};
  CHECK(drive.run({1.0, 0.0}, {wall}).outcome == TrialOutcome::kCollided);
  CHECK(drive.run({1.0, 0.0}, {obstacle}).outcome == TrialOutcome::kCollided);
  drive.rules.forbidden = ForbiddenContacts::kObstacles;
  CHECK(drive.run({1.0, 0.0}, {wall}).outcome == TrialOutcome::kReached);
  CHECK(drive.run({1.0, 0.0}, {obstacle}).outcome == TrialOutcome::kCollided);
  drive.rules.forbidden = ForbiddenContacts::kOwnMotion;
  const TrialScore hit_from_behind = drive.run({1.0, 0.0}, {obstacle});
  CHECK(hit_from_behind.outcome == TrialOutcome::kReached);
  CHECK(hit_from_behind.obstacle_contacts == 1);
  CHECK(hit_from_behind.own_contacts == 0);
  CHECK(hit_from_behind.contact_impulse == Approx(0.03));
}

TEST_CASE("a contact is by own motion when the robot drove at it", "[unit]") {
  Drive drive;
  TrialReferee referee(drive.layout, drive.field, drive.robot, drive.rules, kDt);
  const ContactEvent ahead{
      {BodyKind::kRobot, 0}, {BodyKind::kObstacle, 0}, {0.0, 0.0}, {1.0, 0.0}, 0.01, true};
  drive.advance(referee, {1.0, 0.0});
  drive.advance(referee, {1.0, 0.0}, {ahead});
  CHECK(referee.score().own_contacts == 1);
  // A contact that lasts is counted once, but its impulse is added.
  ContactEvent still = ahead;
  still.began = false;
  drive.advance(referee, {0.0, 0.0}, {still});
  CHECK(referee.score().own_contacts == 1);
  CHECK(referee.score().contact_impulse == Approx(0.02));
}

TEST_CASE("a robot that an obstacle throws at the next one did not drive there", "[unit]") {
  Drive drive;
  TrialReferee referee(drive.layout, drive.field, drive.robot, drive.rules, kDt);
  const auto contact = [](double x) {
    return ContactEvent{{BodyKind::kRobot, 0}, {BodyKind::kObstacle, 0}, {x, 0.0}, {1.0, 0.0}, 0.01, true};
  };
  drive.advance(referee, {0.0, 0.0}, {contact(-0.6)});  // hit from behind at rest
  drive.advance(referee, {1.0, 0.0});
  drive.advance(referee, {1.0, 0.0}, {contact(0.5)});  // flies into the next
  CHECK(referee.score().obstacle_contacts == 2);
  CHECK(referee.score().own_contacts == 0);
  for (int i = 0; i < 40; ++i) drive.advance(referee, {0.1, 0.0});
  drive.advance(referee, {0.1, 0.0}, {contact(0.5)});  // half a second later it drives by itself
  CHECK(referee.score().own_contacts == 1);
}

TEST_CASE("a robot at rest is stuck, a slow one times out, one outside has left the field", "[unit]") {
  Drive drive;
  const TrialScore stuck = drive.run({0.0, 0.0});
  CHECK(stuck.outcome == TrialOutcome::kStuck);
  CHECK(stuck.longest_stuck == Approx(3.0).margin(0.02));
  CHECK(drive.run({0.02, 0.0}).outcome == TrialOutcome::kTimedOut);
  drive.world.robots[0].pose = drive.layout.start;
  CHECK(drive.run({0.0, 2.0}).outcome == TrialOutcome::kLeftField);
}

TEST_CASE("clearance, turning, curvature jumps and jerk are measured", "[unit]") {
  Drive drive;
  TrialReferee referee(drive.layout, drive.field, drive.robot, drive.rules, kDt);
  auto& robot = drive.world.robots[0];
  for (int i = 0; i < 10; ++i) {
    robot.velocity = {0.5, 0.0};
    robot.angular_velocity = i < 5 ? 0.0 : 6.0;  // curvature 0 then 12 /m
    robot.pose.heading += robot.angular_velocity * kDt;
    robot.pose.position.x += 0.5 * kDt;
    const double wheel = i % 2 == 0 ? 10.0 : 10.1;
    referee.observe(drive.world, {}, {wheel, wheel});
  }
  const TrialScore score = referee.score();
  CHECK(score.turning == Approx(5 * 6.0 * kDt));
  CHECK(score.curvature_jumps == 1);
  CHECK(score.wheel_jerk == Approx(0.2 * drive.robot.wheel_radius * 3600.0));
  // The least clearance is that after the first tick, to the posts of the left goal: the robot drives away
  // from it.
  CHECK(score.min_clearance == Approx(norm({0.75 - 0.5 + 0.5 * kDt - 0.0375, 0.20 - 0.0375})));
  CHECK(score.mean_clearance >= score.min_clearance);
}

TEST_CASE("distances between shapes are exact, also where they overlap", "[unit]") {
  const Rectangle square{{{0.0, 0.0}, 0.0}, 2.0, 2.0};
  CHECK(clearance(square, Vec2{3.0, 0.0}, 0.5) == Approx(1.5));
  CHECK(clearance(square, Vec2{2.0, 2.0}, 0.0) == Approx(std::sqrt(2.0)));
  CHECK(clearance(square, Vec2{0.5, 0.0}, 0.25) == Approx(-0.75));
  const Rectangle turned{{{3.0, 0.0}, std::numbers::pi / 4}, 2.0, 2.0};
  CHECK(clearance(square, turned) == Approx(2.0 - std::sqrt(2.0)));
  CHECK(clearance(square, Rectangle{{{1.5, 0.0}, 0.0}, 2.0, 2.0}) == Approx(-0.5));
  CHECK(clearance(square, Rectangle{{{3.0, 3.0}, 0.0}, 2.0, 2.0}) == Approx(std::sqrt(2.0)));
  const std::vector<Vec2> walls = innerContour(FieldGeometry{});
  CHECK(clearance(Rectangle{{{0.70, 0.4}, 0.0}, 0.075, 0.075}, walls) == Approx(0.75 - 0.70 - 0.0375));
  CHECK(clearance(Rectangle{{{0.74, 0.4}, 0.0}, 0.075, 0.075}, walls) == Approx(-0.0275));
  // In the goal mouth the walls are the goal's: its back at 0.85 m, its post at (0.75, 0.20) m.
  CHECK(clearance(Rectangle{{{0.75, 0.0}, 0.0}, 0.075, 0.075}, walls) == Approx(0.85 - 0.75 - 0.0375));
  CHECK(clearance(Rectangle{{{0.75, 0.16}, 0.0}, 0.075, 0.075}, walls) == Approx(0.0025));
  CHECK(clearance(Rectangle{{{0.75, 0.17}, 0.0}, 0.075, 0.075}, walls) < 0.0);
}

}  // namespace fulbito
