#include "tests/support/team_properties.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "fulbito/strategy.hpp"
#include "match/check/command_numbers.hpp"
#include "match/check/mirror.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "strategies/interface/team_frame.hpp"
#include "strategies/team_pilots.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {
namespace {

constexpr RestartKind kRestarts[] = {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                     RestartKind::kPenalty, RestartKind::kGoalKick, RestartKind::kGiven};

struct Scene {
  std::string name;
  Observation seen;
};

int sizeOf(const MatchInfo& info) { return info.rules.team_size; }

std::string gameOf(int team_size) { return team_size == 5 ? "vsss-5v5" : "vsss-3v3"; }

MatchInfo infoOf(int team_size, double age) {
  MatchInfo info;
  info.field = *loadField(gameOf(team_size));
  const RobotPreset preset = *loadRobot("vsss");
  info.robot = preset.robot;
  info.ball = preset.ball;
  info.physics = *loadPhysics("standard");
  info.rules = loadRules(gameOf(team_size)).value();
  info.observation_age = age;
  info.seed = 7;
  return info;
}

Observation emptyScene(const MatchInfo& info) {
  Observation seen;
  seen.dt = info.physics.controlPeriod();
  seen.team_size = sizeOf(info);
  seen.remaining = info.rules.half_seconds;
  return seen;
}

Vec2 drawPlace(const MatchInfo& info, Rng& rng) {
  const double x = rng.uniform(-0.5, 0.5), y = rng.uniform(-0.5, 0.5);
  return {x * (info.field.length - 0.1), y * (info.field.width - 0.1)};
}

ObservedRobot drawRobot(const MatchInfo& info, Rng& rng) {
  ObservedRobot robot;
  robot.present = rng.below(10) > 0;
  robot.state.pose.position = drawPlace(info, rng);
  robot.state.pose.heading = rng.uniform(-3.1, 3.1);
  robot.state.velocity = math::unit(robot.state.pose.heading) * rng.uniform(-1.0, 1.0);
  robot.state.angular_velocity = rng.uniform(-10.0, 10.0);
  return robot;
}

void drawRestart(Observation& seen, Rng& rng) {
  seen.restart = kRestarts[rng.below(std::size(kRestarts))];
  seen.restart_is_ours = rng.below(2) == 1;
  seen.playing = rng.below(5) > 0;
  seen.since_restart = seen.playing ? rng.uniform(0.0, 3.0) : -0.25;
  seen.period = 1 + static_cast<int>(rng.below(4));
  seen.own_score = static_cast<int>(rng.below(3));
}

Scene randomScene(const MatchInfo& info, std::uint64_t seed) {
  Rng rng(seed, kTestStream, 78);
  Scene scene{"random scene " + std::to_string(seed), emptyScene(info)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(sizeOf(info)); ++i) {
    scene.seen.own[i] = drawRobot(info, rng);
    scene.seen.opponents[i] = drawRobot(info, rng);
  }
  scene.seen.ball.position = drawPlace(info, rng);
  const double vx = rng.uniform(-1.5, 1.5), vy = rng.uniform(-1.5, 1.5);
  if (rng.below(4) > 0) scene.seen.ball.velocity = {vx, vy};
  drawRestart(scene.seen, rng);
  return scene;
}

void putRobots(Observation& seen, Vec2 place) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    seen.own[i].state.pose.position = seen.opponents[i].state.pose.position = place;
    seen.own[i].present = seen.opponents[i].present = true;
  }
}

std::vector<Scene> degenerateScenes(const MatchInfo& info) {
  const Scene base = randomScene(info, 4242);
  const double goal_line = info.field.length / 2, corner_y = info.field.width / 2;
  std::vector<Scene> scenes;
  const auto add = [&](std::string name, const auto& change) {
    scenes.push_back(base);
    scenes.back().name = std::move(name);
    change(scenes.back().seen);
  };
  const auto ball_at = [&](std::string name, Vec2 place) {
    add(std::move(name), [place](Observation& seen) { seen.ball = {place, {}, {}}; });
  };
  add("nobody on the field", [](Observation& seen) {
    for (ObservedRobot& robot : seen.own) robot.present = false;
    for (ObservedRobot& robot : seen.opponents) robot.present = false;
  });
  for (std::size_t left = 0; left < static_cast<std::size_t>(sizeOf(info)); ++left) {
    add("only robot " + std::to_string(left) + " left", [left](Observation& seen) {
      for (std::size_t i = 0; i < seen.own.size(); ++i) seen.own[i].present = i == left;
    });
  }
  add("no opponents", [](Observation& seen) {
    for (ObservedRobot& robot : seen.opponents) robot.present = false;
  });
  add("all bodies on one point", [](Observation& seen) {
    putRobots(seen, {0.1, 0.1});
    seen.ball = {{0.1, 0.1}, {}, {}};
  });
  add("all robots in the own goal", [&](Observation& seen) { putRobots(seen, {-goal_line - 0.05, 0.0}); });
  add("robots beyond the walls",
      [&](Observation& seen) { putRobots(seen, {goal_line + 1.0, corner_y + 1.0}); });
  ball_at("ball in a robot", base.seen.own[0].state.pose.position);
  ball_at("ball in the own goal", {-goal_line - 0.08, 0.0});
  ball_at("ball in their goal", {goal_line + 0.08, 0.0});
  ball_at("ball in a corner", {-goal_line + 0.03, corner_y - 0.03});
  ball_at("ball off the field", {3.0, -4.0});
  add("ball faster than any", [](Observation& seen) { seen.ball.velocity = {-60.0, 45.0}; });
  for (const RestartKind kind : kRestarts) {
    for (const bool ours : {true, false}) {
      add(std::string(nameOf(kind)) + (ours ? ", ours, waits" : ", theirs, waits"), [=](Observation& seen) {
        seen.restart = kind, seen.restart_is_ours = ours, seen.playing = false;
        seen.since_restart = -2 * seen.dt;
      });
    }
  }
  return scenes;
}

bool finite(const RobotCommand& command) {
  const GoTo& go_to = command.go_to;
  switch (command.kind) {
    case RobotCommand::Kind::kWheels:
      return std::isfinite(command.wheels.left) && std::isfinite(command.wheels.right);
    case RobotCommand::Kind::kTwist:
      return std::isfinite(command.twist.linear) && std::isfinite(command.twist.angular);
    case RobotCommand::Kind::kGoTo:
      return isFinite(go_to.position) && std::isfinite(go_to.heading.value_or(0.0)) &&
             go_to.speed_limit > 0.0 && go_to.tolerance > 0.0;
  }
  return false;
}

bool finite(const DebugDrawing& drawing) {
  return isFinite(drawing.from) && isFinite(drawing.to) && std::isfinite(drawing.radius);
}

bool withinSaturation(const RobotModel& robot, WheelSpeeds wheels) {
  // Comparisons with NaN are false.
  return std::abs(wheels.left) <= robot.max_wheel_speed && std::abs(wheels.right) <= robot.max_wheel_speed;
}

/// The team with its navigation stage. What it commands moves its robots without slip or contacts.
struct Side {
  std::unique_ptr<Strategy> team;
  TeamPilots pilots;

  Side(const TeamChoice& choice, const MatchInfo& info)
      : team(std::move(makeTeam(choice).value())), pilots(begun(info)) {}

  TeamPilots begun(const MatchInfo& info) {
    team->begin(info);
    return std::move(TeamPilots::create(info, team->navigators()).value());
  }
};

void move(RobotState& robot, double dt) {
  robot.pose.position += robot.velocity * dt;
  robot.pose.heading = math::wrapAngle(robot.pose.heading + robot.angular_velocity * dt);
}

/// The next tick's observation: own robots as `wheels` say, all others straight on.
void advance(Observation& seen, const RobotModel& model,
             const std::array<WheelSpeeds, kMaxTeamSize>& wheels) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    RobotState& own = seen.own[i].state;
    const double top = model.max_wheel_speed;
    const Twist twist = forwardKinematics(
        model, {std::clamp(wheels[i].left, -top, top), std::clamp(wheels[i].right, -top, top)});
    own.velocity = math::unit(own.pose.heading) * twist.linear;
    own.angular_velocity = twist.angular;
    own.wheels = wheels[i];
    move(own, seen.dt);
    move(seen.opponents[i].state, seen.dt);
  }
  seen.sent = wheels;
  seen.ball.position += seen.ball.velocity * seen.dt;
  ++seen.tick;
  seen.since_restart += seen.dt;
  if (seen.since_restart >= 0.0) seen.playing = true;
  seen.remaining -= seen.dt;
}

void checkCommand(const Strategy& team, const Observation& seen, const TeamCommand& command) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
    if (!seen.own[i].present) continue;
    const RobotCommand& robot = command.robots[i];
    INFO("robot " << i);
    REQUIRE(finite(robot));
    if (robot.kind == RobotCommand::Kind::kGoTo) REQUIRE(robot.go_to.navigator < team.navigators().size());
  }
  REQUIRE((seen.wants_drawings || command.drawings.empty()));
  REQUIRE(std::all_of(command.drawings.begin(), command.drawings.end(),
                      [](const DebugDrawing& drawing) { return finite(drawing); }));
}

void checkSound(Side& side, const MatchInfo& info, Scene scene, int ticks) {
  for (int tick = 0; tick < ticks; ++tick) {
    INFO(scene.name << ", tick " << tick);
    scene.seen.wants_drawings = tick % 7 == 3;
    const TeamCommand command = side.team->decide(scene.seen);
    checkCommand(*side.team, scene.seen, command);
    const auto wheels = side.pilots.drive(scene.seen, command);
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      // Wheel speeds of the team's own are cut by the match, not by the navigation stage.
      if (command.robots[i].kind != RobotCommand::Kind::kWheels)
        REQUIRE(withinSaturation(info.robot, wheels[i]));
    }
    advance(scene.seen, info.robot, wheels);
  }
}

void checkSameBits(const TeamChoice& choice, const MatchInfo& info, Scene scene, int ticks) {
  Side one(choice, info), other(choice, info);
  for (int tick = 0; tick < ticks; ++tick) {
    INFO(scene.name << ", tick " << tick);
    const TeamCommand a = one.team->decide(scene.seen), b = other.team->decide(scene.seen);
    for (std::size_t i = 0; i < a.robots.size(); ++i)
      REQUIRE(commandNumbers(a.robots[i]) == commandNumbers(b.robots[i]));
    REQUIRE(a.roles == b.roles);
    const auto wheels = one.pilots.drive(scene.seen, a);
    const auto again = other.pilots.drive(scene.seen, b);
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      REQUIRE(wheels[i].left == again[i].left);
      REQUIRE(wheels[i].right == again[i].right);
    }
    advance(scene.seen, info.robot, wheels);
  }
}

void checkMirrored(const TeamChoice& choice, const MatchInfo& info, Scene scene, int ticks) {
  Side plain(choice, info), image(choice, info);
  for (int tick = 0; tick < ticks; ++tick) {
    const TeamCommand command = plain.team->decide(scene.seen);
    const TeamCommand other = image.team->decide(mirrored(scene.seen));
    for (std::size_t i = 0; i < static_cast<std::size_t>(sizeOf(info)); ++i) {
      if (!scene.seen.own[i].present) continue;
      INFO(scene.name << ", tick " << tick << ", robot " << i);
      const auto wanted = commandNumbers(mirrored(command.robots[i])), got = commandNumbers(other.robots[i]);
      REQUIRE(wanted.size() == got.size());
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        INFO("number " << k << " of the command");
        REQUIRE(got[k] == Approx(wanted[k]).margin(1e-6).epsilon(1e-6));
      }
    }
    advance(scene.seen, info.robot, plain.pilots.drive(scene.seen, command));
  }
}

std::uint64_t allocationsOfRun(Side& side, const MatchInfo& info, const TeamProperties& properties) {
  std::uint64_t inside = 0;
  for (int seed = 0; seed < properties.scenes; ++seed) {
    Scene scene = randomScene(info, static_cast<std::uint64_t>(seed));
    for (int tick = 0; tick < properties.ticks; ++tick) {
      const std::uint64_t before = allocationCount();
      const TeamCommand command = side.team->decide(scene.seen);
      inside += allocationCount() - before;
      advance(scene.seen, info.robot, side.pilots.drive(scene.seen, command));
    }
  }
  return inside;
}

TeamPlacement turned(fulbito::Side side, const TeamPlacement& poses) {
  TeamPlacement result;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) result[i] = inTeamFrame(side, *poses[i]);
  }
  return result;
}

RefereeSetup refereeOf(const MatchInfo& info) {
  RefereeSetup setup;
  setup.rules = info.rules;
  setup.field = info.field;
  setup.robot = info.robot;
  setup.ball = info.ball;
  setup.dt = info.physics.controlPeriod();
  return setup;
}

/// Asks `team`, which plays as `id`, for its places at `call` and lets the referee judge them.
void checkPlaces(Strategy& team, TeamId id, const RefereeSetup& setup, const RestartCall& call) {
  const RefereeState state;
  const fulbito::Side side = state.sideOf(id);
  PlacementRequest request;
  request.kind = call.kind;
  request.ours = call.team == id;
  request.ball = inTeamFrame(side, call.ball);
  request.defaults = turned(side, defaultPoses(call, id));
  if (!request.ours) request.opponents = turned(side, defaultPoses(call, call.team));
  const auto proposal = team.place(request);
  if (!proposal) return;
  for (const auto& pose : proposal->robots) REQUIRE((!pose || isFinite(pose->position)));
  Proposals proposals;
  proposals[indexOf(id)] = turned(side, proposal->robots);
  std::vector<GameEvent> log;
  place(setup, state, call, proposals, log);
  for (const GameEvent& event : log) {
    INFO(nameOf(call.kind) << ", " << (request.ours ? "ours" : "theirs") << ": robot "
                           << int(event.robot.value_or(99)) << " moved by " << event.value << " m");
    REQUIRE(event.team != id);
  }
}

void checkRestarts(const TeamChoice& choice, const MatchInfo& info) {
  const RefereeSetup setup = refereeOf(info);
  const Vec2 balls[] = {{0.0, 0.0}, {0.5, 0.3}, {0.5, -0.3}, {-0.5, 0.3}, {-0.5, -0.3}};
  Side side(choice, info);
  for (const RestartKind kind : kRestarts) {
    if (kind == RestartKind::kGiven) continue;
    for (const TeamId taker : kTeams) {
      for (const Vec2 ball : balls) {
        const RestartCall call = makeCall(setup, {}, {kind, taker, ball, nullptr});
        for (const TeamId id : kTeams) checkPlaces(*side.team, id, setup, call);
      }
    }
  }
}

void checkGame(const TeamChoice& choice, const MatchInfo& info, const TeamProperties& properties) {
  INFO(sizeOf(info) << " robots, pictures " << info.observation_age << " s old");
  Side side(choice, info);
  // One team goes through all scenes, as through the plays of a match.
  for (const Scene& scene : degenerateScenes(info)) checkSound(side, info, scene, properties.ticks);
  for (int seed = 0; seed < properties.scenes; ++seed) {
    const Scene scene = randomScene(info, static_cast<std::uint64_t>(seed));
    checkSound(side, info, scene, properties.ticks);
    checkSameBits(choice, info, scene, properties.ticks);
    if (properties.mirrored) checkMirrored(choice, info, scene, properties.ticks);
  }
  if (!properties.allocates) REQUIRE(allocationsOfRun(side, info, properties) == 0);
}

}  // namespace

void checkTeamProperties(const std::string& specification, TeamProperties properties) {
  INFO(specification);
  const auto choice = parseTeam(specification);
  REQUIRE(choice);
  for (const int size : {3, 5}) {
    checkRestarts(*choice, infoOf(size, 0.0));
    for (const double age : {0.0, 3.0 / 60.0}) checkGame(*choice, infoOf(size, age), properties);
  }
}

}  // namespace fulbito::test
