#include "bridge/abi/team_values.hpp"

#include <cstring>
#include <limits>

#include "fulbito/team.hpp"
#include "navigation/library/plugin_host.hpp"
#include "navigation/library/plugin_values.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/field_count.hpp"

namespace fulbito {
namespace {

using test::fieldCount;

/// Numbers that differ from each other and from every default.
class Counter {
 public:
  double number() { return 1000.0 + ++last_; }
  int whole() { return 1000 + ++last_; }
  Vec2 point() { return {number(), number()}; }
  Pose2 pose() { return {point(), number()}; }
  WheelSpeeds wheels() { return {number(), number()}; }

 private:
  int last_ = 0;
};

bool same(Vec2 a, team::Vec2 b) { return a.x == b.x && a.y == b.y; }
bool same(const Pose2& a, const team::Pose& b) {
  return same(a.position, b.position) && a.heading == b.heading;
}
bool same(WheelSpeeds a, team::Wheels b) { return a.left == b.left && a.right == b.right; }

Observation someObservation(Counter& next, int team_size = 3) {
  Observation seen;
  seen.tick = next.whole();
  seen.dt = next.number();
  seen.team_size = team_size;
  for (auto* robots : {&seen.own, &seen.opponents}) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
      (*robots)[i] = {i != 1, {next.pose(), next.point(), next.number(), next.wheels()}};
    }
  }
  seen.ball = {next.point(), next.point(), {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) seen.sent[i] = next.wheels();
  seen.playing = false;
  seen.restart = RestartKind::kGoalKick;
  seen.restart_is_ours = true;
  seen.since_restart = next.number();
  seen.period = 3;
  seen.remaining = next.number();
  seen.own_score = next.whole();
  seen.opponent_score = next.whole();
  seen.wants_drawings = true;
  return seen;
}

void checkSame(const ObservedRobot& from, const team::Robot& to) {
  CHECK(to.present == from.present);
  const RobotState state = from.present ? from.state : RobotState{};
  CHECK(same(state.pose.position, to.position));
  CHECK(to.heading == state.pose.heading);
  CHECK(same(state.velocity, to.velocity));
  CHECK(to.angular_velocity == state.angular_velocity);
  CHECK(same(state.wheels, to.wheels));
}

void checkSame(const Observation& from, const team::Observation& to) {
  CHECK(to.tick == from.tick);
  CHECK(to.dt == from.dt);
  CHECK(to.team_size == from.team_size);
  for (std::size_t i = 0; i < static_cast<std::size_t>(kMaxTeamSize); ++i) {
    CAPTURE(i);
    checkSame(from.own[i], to.own[i]);
    checkSame(from.opponents[i], to.opponents[i]);
    CHECK(same(from.sent[i], to.sent[i]));
  }
  CHECK(same(from.ball.position, to.ball.position));
  CHECK(same(from.ball.velocity, to.ball.velocity));
  CHECK(to.playing == from.playing);
  CHECK(static_cast<int>(to.restart) == static_cast<int>(from.restart));
  CHECK(to.restart_is_ours == from.restart_is_ours);
  CHECK(to.since_restart == from.since_restart);
  CHECK(to.period == from.period);
  CHECK(to.remaining == from.remaining);
  CHECK(to.own_score == from.own_score);
  CHECK(to.opponent_score == from.opponent_score);
  CHECK(to.wants_drawings == from.wants_drawings);
}

GameEvent someCall(Counter& next) {
  GameEvent event;
  event.tick = next.whole();
  event.play_time = next.number();
  event.period = 2;
  event.clause = "goal-kick.attackers";
  event.law = "8.2";
  event.team = TeamId::kYellow;
  event.robot = 4;
  event.place = next.point();
  event.value = next.number();
  event.threshold = next.number();
  event.margin = next.number();
  return event;
}

void checkSame(const GameEvent& from, const team::Call& to) {
  CHECK(to.tick == from.tick);
  CHECK(to.play_time == from.play_time);
  CHECK(to.period == from.period);
  CHECK(to.clause == from.clause);
  CHECK(to.law == from.law);
  CHECK(to.team == team::Colour::kYellow);
  CHECK(to.robot == 4);
  CHECK(same(from.place, to.place));
  CHECK(to.value == from.value);
  CHECK(to.threshold == from.threshold);
  CHECK(to.margin == from.margin);
}

FieldGeometry someField(Counter& next) {
  FieldGeometry field;
  field.name = "a field";
  for (double* member : {&field.length, &field.width, &field.goal_width, &field.goal_depth, &field.corner,
                         &field.wall_thickness, &field.goal_area_width, &field.goal_area_depth,
                         &field.goal_area_arc_width, &field.goal_area_arc_depth, &field.big_area_width,
                         &field.big_area_depth, &field.centre_circle_radius, &field.penalty_mark}) {
    *member = next.number();
  }
  field.free_ball_mark = next.point();
  return field;
}

RobotModel someRobot(Counter& next) {
  RobotModel robot;
  robot.name = "a robot";
  for (double* member : {&robot.length,
                         &robot.width,
                         &robot.mass,
                         &robot.wheel_radius,
                         &robot.axle_track,
                         &robot.max_wheel_speed,
                         &robot.wheel_acceleration,
                         &robot.wheel_braking,
                         &robot.yaw_acceleration,
                         &robot.rolling_drag,
                         &robot.longitudinal_grip,
                         &robot.lateral_grip,
                         &robot.spin_slow_speed,
                         &robot.spin_slow_ratio,
                         &robot.spin_fast_speed,
                         &robot.spin_fast_ratio,
                         &robot.friction,
                         &robot.restitution,
                         &robot.curve_widening,
                         &robot.curve_widening_rise}) {
    *member = next.number();
  }
  return robot;
}

/// The bytes of both are equal, apart from the text at the start of the second one's C++ form.
void checkSame(const RobotModel& from, const team::RobotModel& to) {
  CHECK(to.name == from.name);
  CHECK(to.length == from.length);
  CHECK(to.width == from.width);
  CHECK(to.mass == from.mass);
  CHECK(to.wheel_radius == from.wheel_radius);
  CHECK(to.axle_track == from.axle_track);
  CHECK(to.max_wheel_speed == from.max_wheel_speed);
  CHECK(to.wheel_acceleration == from.wheel_acceleration);
  CHECK(to.wheel_braking == from.wheel_braking);
  CHECK(to.yaw_acceleration == from.yaw_acceleration);
  CHECK(to.rolling_drag == from.rolling_drag);
  CHECK(to.longitudinal_grip == from.longitudinal_grip);
  CHECK(to.lateral_grip == from.lateral_grip);
  CHECK(to.spin_slow_speed == from.spin_slow_speed);
  CHECK(to.spin_slow_ratio == from.spin_slow_ratio);
  CHECK(to.spin_fast_speed == from.spin_fast_speed);
  CHECK(to.spin_fast_ratio == from.spin_fast_ratio);
  CHECK(to.friction == from.friction);
  CHECK(to.restitution == from.restitution);
  CHECK(to.curve_widening == from.curve_widening);
  CHECK(to.curve_widening_rise == from.curve_widening_rise);
  CHECK(to.maxSpeed() == from.maxSpeed());
  CHECK(to.circumradius() == Approx(from.circumradius()));
}

void checkSame(const FieldGeometry& from, const team::Field& to) {
  CHECK(to.name == from.name);
  CHECK(to.length == from.length);
  CHECK(to.width == from.width);
  CHECK(to.goal_width == from.goal_width);
  CHECK(to.goal_depth == from.goal_depth);
  CHECK(to.corner == from.corner);
  CHECK(to.wall_thickness == from.wall_thickness);
  CHECK(to.goal_area_width == from.goal_area_width);
  CHECK(to.goal_area_depth == from.goal_area_depth);
  CHECK(to.goal_area_arc_width == from.goal_area_arc_width);
  CHECK(to.goal_area_arc_depth == from.goal_area_arc_depth);
  CHECK(to.big_area_width == from.big_area_width);
  CHECK(to.big_area_depth == from.big_area_depth);
  CHECK(to.centre_circle_radius == from.centre_circle_radius);
  CHECK(to.penalty_mark == from.penalty_mark);
  CHECK(same(from.free_ball_mark, to.free_ball_mark));
}

BallModel someBall(Counter& next) {
  return {next.number(), next.number(), next.number(), next.number(), next.number(),
          next.number(), next.number(), next.number(), next.number(), next.number()};
}

void checkSame(const BallModel& from, const team::BallModel& to) {
  CHECK(to.radius == from.radius);
  CHECK(to.mass == from.mass);
  CHECK(to.roll_keep == from.roll_keep);
  CHECK(to.slide_deceleration == from.slide_deceleration);
  CHECK(to.roll_deceleration == from.roll_deceleration);
  CHECK(to.stop_speed == from.stop_speed);
  CHECK(to.wall_restitution == from.wall_restitution);
  CHECK(to.wall_spin_keep == from.wall_spin_keep);
  CHECK(to.robot_restitution == from.robot_restitution);
  CHECK(to.friction == from.friction);
}

PhysicsProfile somePhysics(Counter& next) {
  return {"some physics", next.whole(),  next.whole(),  next.whole(),  next.whole(),
          false,          next.number(), next.number(), next.number(), next.number()};
}

void checkSame(const PhysicsProfile& from, const team::Physics& to) {
  CHECK(to.name == from.name);
  CHECK(to.control_rate == from.control_rate);
  CHECK(to.substeps == from.substeps);
  CHECK(to.velocity_iterations == from.velocity_iterations);
  CHECK(to.position_iterations == from.position_iterations);
  CHECK(to.bullet_ball == from.bullet_ball);
  CHECK(to.contact_depth == from.contact_depth);
  CHECK(to.max_ball_speed == from.max_ball_speed);
  CHECK(to.restitution_threshold == from.restitution_threshold);
  CHECK(to.wheel_command_step == from.wheel_command_step);
}

void checkSame(const TeamPlacement& from, const team::Poses& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    CAPTURE(i);
    REQUIRE(to[i].has_value() == from[i].has_value());
    if (from[i]) CHECK(same(*from[i], *to[i]));
  }
}

TeamPlacement somePoses(Counter& next) {
  TeamPlacement poses;
  for (std::size_t i = 0; i < poses.size(); i += 2) poses[i] = next.pose();
  return poses;
}

}  // namespace

TEST_CASE("no member of a team's values lacks its place in the C interface", "[unit]") {
  // A new member needs its place in fulbito/team.h, team.hpp, bridge/abi/team_values.cpp and the tests below.
  CHECK(fieldCount<MatchInfo>() == 13);
  CHECK(fieldCount<DecisionTime>() == 5);  // a team has no use for `start` and `failures`
  CHECK(fieldCount<FieldGeometry>() == 16);
  // The structs of fulbito/team.h are fixed: two members for the slip in curves are in an extension of the
  // host. Teams need no more of the eight that tell how wheels and supports stand: their predictions hold for
  // a level robot.
  CHECK(fieldCount<RobotModel>() == 19 + 2 + 8);
  CHECK(fieldCount<BallModel>() == 10);
  CHECK(fieldCount<PhysicsProfile>() == 10);
  CHECK(fieldCount<Observation>() == 16);
  CHECK(fieldCount<ObservedRobot>() == 2);
  CHECK(fieldCount<RobotState>() == 4);
  CHECK(fieldCount<BallState>() == 3);
  CHECK(fieldCount<PlacementRequest>() == 8);
  CHECK(fieldCount<GameEvent>() == 11);
  CHECK(fieldCount<PlayStop>() == 2);
  CHECK(fieldCount<MatchEnd>() == 6);
  CHECK(fieldCount<Exercise>() == 5);
  CHECK(fieldCount<ExerciseReply>() == 2);
  CHECK(fieldCount<TeamCommand>() == 3);
  CHECK(fieldCount<RobotCommand>() == 4);
  CHECK(fieldCount<GoTo>() == 10);
  CHECK(fieldCount<DebugDrawing>() == 5);
}

TEST_CASE("what a team knows before the match arrives whole", "[unit]") {
  Counter next;
  MatchInfo info;
  info.team = TeamId::kYellow;
  info.side = Side::kRight;
  info.field = someField(next);
  info.robot = someRobot(next);
  info.ball = someBall(next);
  info.physics = somePhysics(next);
  info.observation_age = next.number();
  info.position_noise = next.number();
  info.heading_noise = next.number();
  info.dropout = next.number();
  info.decision_time = DecisionTime{next.number(), next.number(), next.whole()};
  info.seed = 0xfedcba9876543210u;
  team::Info known = team::detail::from(toAbi(info));
  PluginHost host("a test", {});
  host.know(wideningToAbi(info.robot));
  team::detail::takeCurveWidening(*host.table(), known.robot);
  CHECK(known.colour == team::Colour::kYellow);
  CHECK_FALSE(known.left);
  checkSame(info.field, known.field);
  checkSame(info.robot, known.robot);
  checkSame(info.ball, known.ball);
  checkSame(info.physics, known.physics);
  CHECK(known.dt == info.dt());
  CHECK(known.observation_age == info.observation_age);
  CHECK(known.position_noise == info.position_noise);
  CHECK(known.heading_noise == info.heading_noise);
  CHECK(known.dropout == info.dropout);
  REQUIRE(known.decision_time);
  CHECK(known.decision_time->decision == info.decision_time->decision);
  CHECK(known.decision_time->bank == info.decision_time->bank);
  CHECK(known.decision_time->held == info.decision_time->held);
  CHECK(known.seed == info.seed);
  info.decision_time.reset();
  CHECK_FALSE(team::detail::from(toAbi(info)).decision_time);
}

TEST_CASE("the rules that teams need arrive", "[unit]") {
  Counter next;
  MatchInfo info;
  Rules& rules = info.rules;
  rules.name = "some rules";
  rules.team_size = 5;
  rules.half_seconds = next.number();
  rules.periods = {FirstKickOff::kBlue, false,        true,          next.whole(),
                   TieBreak::kBoth,     next.whole(), next.number(), false};
  rules.shoot_out.kick_seconds = next.number();
  rules.restart.delay = next.number();
  rules.restart.goal_delay = next.number();
  rules.restart.hold_robots = false;
  rules.restart.false_start_distance = next.number();
  rules.free_ball.distance = next.number();
  rules.goal_kick.ball_free = false;
  rules.stuck.seconds = next.number();
  rules.stuck.area_seconds = next.number();
  rules.stuck.radius = next.number();
  rules.areas.arc = false;
  rules.areas.attackers_max = next.whole();
  rules.areas.big_attackers_max = next.whole();
  rules.areas.defenders_max = next.whole();
  rules.areas.big_defenders_max = next.whole();
  rules.keeper.hold_seconds = next.number();
  rules.keeper.charged = false;
  rules.fouls.push = true;
  rules.fouls.holding = true;
  rules.fouls.pinned_seconds = next.number();
  const team::Rules known = team::detail::from(toAbi(info)).rules;
  CHECK(known.name == rules.name);
  CHECK(known.team_size == 5);
  CHECK(known.half_seconds == rules.half_seconds);
  CHECK(known.swap_sides);
  CHECK(known.mercy_goals == rules.periods.mercy_goals);
  CHECK(known.tie_break == team::TieBreak::kBoth);
  CHECK(known.overtime_parts == rules.periods.overtime_parts);
  CHECK(known.overtime_seconds == rules.periods.overtime_seconds);
  CHECK_FALSE(known.golden_goal);
  CHECK(known.kick_seconds == rules.shoot_out.kick_seconds);
  CHECK(known.restart_delay == rules.restart.delay);
  CHECK(known.goal_delay == rules.restart.goal_delay);
  CHECK_FALSE(known.hold_robots);
  CHECK(known.false_start_distance == rules.restart.false_start_distance);
  CHECK(known.free_ball_distance == rules.free_ball.distance);
  CHECK_FALSE(known.goal_kick_ball_free);
  CHECK(known.stuck_seconds == rules.stuck.seconds);
  CHECK(known.stuck_area_seconds == rules.stuck.area_seconds);
  CHECK(known.stuck_radius == rules.stuck.radius);
  CHECK_FALSE(known.areas_have_arc);
  CHECK(known.attackers_max == rules.areas.attackers_max);
  CHECK(known.big_attackers_max == rules.areas.big_attackers_max);
  CHECK(known.defenders_max == rules.areas.defenders_max);
  CHECK(known.big_defenders_max == rules.areas.big_defenders_max);
  CHECK(known.keeper_hold_seconds == rules.keeper.hold_seconds);
  CHECK_FALSE(known.keeper_charging);
  CHECK(known.pushing);
  CHECK(known.pinning);
  CHECK(known.pinned_seconds == rules.fouls.pinned_seconds);
  rules.areas.attackers = rules.areas.defenders = rules.keeper.holding = false;
  const team::Rules without = team::detail::from(toAbi(info)).rules;
  CHECK(without.attackers_max == -1);
  CHECK(without.big_attackers_max == -1);
  CHECK(without.defenders_max == -1);
  CHECK(without.big_defenders_max == -1);
  CHECK(without.keeper_hold_seconds == 0.0);
}

TEST_CASE("an observation arrives whole, for every team size", "[unit]") {
  for (int team_size : {1, 3, kMaxTeamSize}) {
    CAPTURE(team_size);
    Counter next;
    const Observation seen = someObservation(next, team_size);
    fulbito_observation abi{};
    toAbi(seen, abi);
    checkSame(seen, team::detail::from(abi));
  }
}

TEST_CASE("an observation written over an older one keeps nothing of it", "[unit]") {
  Counter next;
  fulbito_observation abi{};
  toAbi(someObservation(next), abi);
  Observation later = someObservation(next);
  later.own[0].present = later.opponents[2].present = false;
  toAbi(later, abi);
  fulbito_observation fresh{};
  toAbi(later, fresh);
  CHECK(std::memcmp(&abi, &fresh, sizeof abi) == 0);
  checkSame(later, team::detail::from(abi));
}

TEST_CASE("placement requests, notices and exercises arrive whole", "[unit]") {
  Counter next;
  PlacementRequest request;
  request.kind = RestartKind::kPenalty;
  request.ours = true;
  request.ball = next.point();
  request.defaults = somePoses(next);
  request.opponents = somePoses(next);
  request.cause = someCall(next);
  request.delay = next.number();
  request.now = someObservation(next);
  fulbito_placement_request asked{};
  toAbi(request, asked);
  const team::PlacementRequest got = team::detail::from(asked);
  CHECK(got.kind == team::Restart::kPenalty);
  CHECK(got.ours);
  CHECK(same(request.ball, got.ball));
  checkSame(request.defaults, got.defaults);
  REQUIRE(got.opponents);
  checkSame(*request.opponents, *got.opponents);
  checkSame(request.cause, got.cause);
  CHECK(got.delay == request.delay);
  checkSame(request.now, got.now);

  const PlayStop stop{someCall(next), someObservation(next)};
  fulbito_stop notice{};
  toAbi(stop, notice);
  checkSame(stop.cause, team::detail::from(notice.cause));
  checkSame(stop.now, team::detail::from(notice.now));

  const MatchEnd end{MatchEnd::Reason::kInterrupted,
                     someCall(next),
                     next.whole(),
                     next.whole(),
                     next.whole(),
                     TeamId::kYellow};
  const team::End ended = team::detail::from(toAbi(end));
  CHECK(ended.reason == team::End::Reason::kInterrupted);
  checkSame(end.cause, ended.cause);
  CHECK(ended.tick == end.tick);
  CHECK(ended.own_score == end.own_score);
  CHECK(ended.opponent_score == end.opponent_score);
  CHECK(ended.winner == team::Colour::kYellow);
  CHECK_FALSE(team::detail::from(toAbi(MatchEnd{})).winner);
  CHECK_FALSE(team::detail::from(toAbi(MatchEnd{})).cause.team);

  const Exercise exercise{Exercise::Kind::kPush, next.point(), next.number(), next.number(), next.number()};
  const team::Exercise task = team::detail::from(toAbi(exercise));
  CHECK(task.kind == team::Exercise::Kind::kPush);
  CHECK(same(exercise.target, task.target));
  CHECK(task.heading == exercise.heading);
  CHECK(task.speed == exercise.speed);
  CHECK(task.horizon == exercise.horizon);
}

TEST_CASE("commands come back whole", "[unit]") {
  team::Commands commands;
  commands.wheels(0, 1.5, -2.5);
  commands.twist(1, 0.25, 3.5);
  team::GoTo place;
  place.position = {0.5, -0.25};
  place.heading = 1.25;
  place.stop = true;
  place.speed_limit = 0.75;
  place.avoid_ball = true;
  place.avoid_mates = false;
  place.avoid_opponents = false;
  place.tolerance = 0.0625;
  place.either_front = false;
  place.navigator = 3;
  commands.goTo(10, place);
  commands.roles = {1, 2, 255};
  commands.line({0.1, 0.2}, {0.3, 0.4});
  commands.circle({0.5, 0.6}, 0.7);
  commands.text({0.8, 0.9}, "here");
  CommandRoom room;
  fulbito_team_command abi = room.open(true);
  team::detail::give(commands, kMaxTeamSize, abi);
  room.close(abi);
  TeamCommand got;
  fromAbi(abi, kMaxTeamSize, got);
  CHECK(got.robots[0].kind == RobotCommand::Kind::kWheels);
  CHECK(same(got.robots[0].wheels, {1.5, -2.5}));
  CHECK(got.robots[1].kind == RobotCommand::Kind::kTwist);
  CHECK(got.robots[1].twist.linear == 0.25);
  CHECK(got.robots[1].twist.angular == 3.5);
  CHECK(got.robots[10].kind == RobotCommand::Kind::kGoTo);
  const GoTo& go_to = got.robots[10].go_to;
  CHECK(same(go_to.position, place.position));
  CHECK(go_to.heading == 1.25);
  CHECK(go_to.stop);
  CHECK(go_to.speed_limit == 0.75);
  CHECK(go_to.avoid_ball);
  CHECK_FALSE(go_to.avoid_mates);
  CHECK_FALSE(go_to.avoid_opponents);
  CHECK(go_to.tolerance == 0.0625);
  CHECK_FALSE(go_to.either_front);
  CHECK(go_to.navigator == 3);
  CHECK_FALSE(got.robots[0].go_to.heading);
  CHECK(got.roles[0] == 1);
  CHECK(got.roles[2] == 255);
  REQUIRE(got.drawings.size() == 3);
  CHECK(got.drawings[0].kind == DebugDrawing::Kind::kLine);
  CHECK(same(got.drawings[0].to, {0.3, 0.4}));
  CHECK(got.drawings[1].kind == DebugDrawing::Kind::kCircle);
  CHECK(got.drawings[1].radius == 0.7);
  CHECK(same(got.drawings[2].from, {0.8, 0.9}));
  CHECK(got.drawings[2].text == "here");
}

TEST_CASE("a command that a team leaves alone is the simulator's default", "[unit]") {
  CommandRoom room;
  TeamCommand got;
  fromAbi(room.open(false), kMaxTeamSize, got);
  const GoTo by_default;
  for (const RobotCommand& robot : got.robots) {
    CHECK(robot.kind == RobotCommand::Kind::kWheels);
    CHECK(robot.wheels.left == 0.0);
    CHECK(robot.go_to.speed_limit == by_default.speed_limit);
    CHECK(robot.go_to.tolerance == by_default.tolerance);
    CHECK(robot.go_to.avoid_ball == by_default.avoid_ball);
    CHECK(robot.go_to.avoid_mates == by_default.avoid_mates);
    CHECK(robot.go_to.avoid_opponents == by_default.avoid_opponents);
    CHECK(robot.go_to.either_front == by_default.either_front);
  }
  CHECK(got.drawings.empty());
  fulbito_team_command abi = room.open(false);
  team::detail::give({}, kMaxTeamSize, abi);
  TeamCommand from_class;
  fromAbi(abi, kMaxTeamSize, from_class);
  CHECK(from_class.robots[4].go_to.speed_limit == std::numeric_limits<double>::infinity());
  CHECK(from_class.robots[4].go_to.tolerance == by_default.tolerance);
}

TEST_CASE("placements come back whole", "[unit]") {
  team::Placement wish;
  wish.robots[2] = team::Pose{{-0.5, 0.25}, 1.5};
  wish.ball = team::Vec2{0.125, 0.375};
  fulbito_placement abi{};
  team::detail::give(wish, abi);
  const TeamProposal got = fromAbi(abi);
  CHECK_FALSE(got.robots[0]);
  REQUIRE(got.robots[2]);
  CHECK(same(*got.robots[2], *wish.robots[2]));
  REQUIRE(got.ball);
  CHECK(same(*got.ball, *wish.ball));
  CHECK_FALSE(fromAbi(fulbito_placement{}).ball);
}

TEST_CASE("a long name is cut between characters and ends with a zero byte", "[unit]") {
  char name[FULBITO_NAME_SIZE];
  copyName(std::string(62, 'a') + "\xc3\xa9", name);
  CHECK(std::string(name) == std::string(62, 'a'));
  copyName(std::string(200, 'b'), name);
  CHECK(std::string(name) == std::string(63, 'b'));
}

}  // namespace fulbito
