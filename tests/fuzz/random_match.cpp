#include "tests/fuzz/random_match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "fulbito/world.hpp"
#include "referee/restarts/goal_kick_ball.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "referee/rules/clauses.hpp"
#include "referee/state/ticks.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/worlds.hpp"

namespace fulbito::test {
namespace {

/// What a robot does for a while.
struct Mood {
  bool chases = false;
  WheelSpeeds wheels;
  Tick until = 0;
};

/// Counts for how long the ball has stayed at its place, in a way of its own.
struct StuckMonitor {
  Vec2 anchor;
  Tick since = 0;
  Tick slow_since = -1;

  void restart(Vec2 ball, Tick tick) { anchor = ball, since = tick, slow_since = -1; }

  /// Law 8.1 has a count of its own for a ball that a keeper may hold.
  void pause() {
    ++since;
    if (slow_since >= 0) ++slow_since;
  }

  /// Ticks after which the rules must have called: a ball within half the rules' circle for twice their time,
  /// or slower than their speed for their time.
  bool overdue(const RefereeSetup& setup, const BallState& ball, Tick tick) {
    const StuckRules& rules = setup.rules.stuck;
    const Tick allowed = ticksOf(std::max(rules.seconds, rules.area_seconds), setup.dt);
    if (distance(ball.position, anchor) > rules.radius / 2) anchor = ball.position, since = tick;
    if (norm(ball.velocity) > rules.speed) slow_since = -1;
    if (norm(ball.velocity) <= rules.speed && slow_since < 0) slow_since = tick;
    if (rules.measure == StuckMeasure::kRadius) return tick - since > 2 * allowed + 2;
    return slow_since >= 0 && tick - slow_since > allowed + 1;
  }
};

class Game {
 public:
  explicit Game(const RandomMatch& match)
      : match_(match), referee_(match.setup), rng_(match.setup.seed, kTestStream) {}

  RandomMatchResult play() {
    begin(referee_.open());
    while (result_.fault.empty() && result_.ticks < match_.ticks && !referee_.state().ended) tick();
    return result_;
  }

 private:
  void begin(RestartCall call);
  Proposals proposals(const RestartCall& call);
  void tick();
  void drive();
  void judge();
  bool mayBeHeld(const WorldState& now) const;
  void checkScore(const PerTeam<int>& before);
  void checkBodies();
  void blame(const std::string& fault) {
    if (result_.fault.empty()) result_.fault = fmt::format("tick {}: {}", result_.ticks, fault);
  }

  RandomMatch match_;
  MatchReferee referee_;
  Rng rng_;
  std::optional<World> world_;
  std::vector<RobotId> ids_;
  std::vector<Mood> moods_;
  std::vector<WheelSpeeds> commands_;
  std::vector<GameEvent> events_;
  StuckMonitor stuck_;
  Tick stopped_ = 0;  ///< ticks since play was stopped last
  Tick quick_ = 0;    ///< stoppages that came within a quarter of a second of the restart
  RandomMatchResult result_;
};

Proposals Game::proposals(const RestartCall& call) {
  Proposals wishes;
  if (!match_.proposals) return wishes;
  const FieldGeometry& field = match_.setup.field;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TeamId team : kTeams) {
    if (rng_.below(4) == 0) continue;
    TeamPoses poses = call.defaults.robots[indexOf(team)];
    for (auto& pose : poses) {
      const auto what = rng_.below(8);
      if (what < 3) continue;
      pose = Pose2{
          {rng_.uniform(-field.length, field.length) * 0.6, rng_.uniform(-field.width, field.width) * 0.6},
          rng_.uniform(-3.0, 3.0)};
      if (what == 3) pose = Pose2{call.ball, 0.0};
      if (what == 4) pose->position.x = nan;
    }
    wishes[indexOf(team)] = poses;
  }
  return wishes;
}

void Game::begin(RestartCall call) {
  std::vector<GameEvent> log;
  const RefereeSetup& setup = match_.setup;
  if (match_.proposals && rng_.below(2) == 0) {
    const FieldGeometry& field = setup.field;
    call =
        withBall(setup, referee_.state(), call,
                 {rng_.uniform(-field.length, field.length), rng_.uniform(-field.width, field.width)}, log);
  }
  const Placement placement = place(setup, referee_.state(), call, proposals(call), log);
  result_.repairs += static_cast<int>(log.size());
  if (const auto flaw = findPlacementFlaw(setup, referee_.state(), call, placement)) {
    blame(fmt::format("{}: {} {} {}", nameOf(call.kind), nameOf(flaw->team), flaw->robot, flaw->reason));
  }
  ids_.clear();
  WorldConfig config{setup.field, match_.physics, {}, {}, {}};
  for (const TeamId team : kTeams) {
    for (int i = 0; i < kMaxTeamSize; ++i) {
      const auto& pose = placement.robots[indexOf(team)][static_cast<std::size_t>(i)];
      if (!pose) continue;
      ids_.push_back({team, static_cast<std::uint8_t>(i)});
      config.robots.push_back({setup.robot, *pose, {}, 0.0});
    }
  }
  config.balls.push_back({setup.ball, placement.ball, placement.ball_velocity, {}});
  auto world = World::create(config);
  if (!world) return blame(world.error().message);
  world_.emplace(std::move(*world));
  moods_.assign(ids_.size(), {});
  commands_.assign(ids_.size(), {});
  referee_.restarted(call, placement, result_.ticks);
  stuck_.restart(placement.ball, result_.ticks);
  stopped_ = 0;
}

void Game::drive() {
  const bool held = !referee_.state().playing && match_.setup.rules.restart.hold_robots;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    Mood& mood = moods_[i];
    if (result_.ticks >= mood.until) {
      mood.until = result_.ticks + 10 + rng_.below(80);
      mood.chases = rng_.uniform() < match_.eager;
      const bool stands = rng_.uniform() < match_.idle;
      mood.wheels = stands ? WheelSpeeds{} : WheelSpeeds{rng_.uniform(-40, 40), rng_.uniform(-40, 40)};
    }
    const WorldState& now = world_->state();
    commands_[i] = mood.chases ? chase(now.robots[i], now.balls.front().position) : mood.wheels;
    if (held) commands_[i] = {};
  }
}

void Game::checkScore(const PerTeam<int>& before) {
  PerTeam<int> goals{};
  for (const GameEvent& event : events_) {
    if (event.clause == clause::kGoal && event.team) ++goals[indexOf(*event.team)];
  }
  for (const TeamId team : kTeams) {
    const int change = referee_.state().score[indexOf(team)] - before[indexOf(team)];
    if (change != goals[indexOf(team)]) blame("the score changed without a goal");
  }
}

void Game::checkBodies() {
  const FieldGeometry& field = match_.setup.field;
  for (const RobotState& robot : world_->state().robots) {
    if (!insideField(field, robot.pose.position)) blame("a robot left the field");
  }
  if (!insideField(field, world_->state().balls.front().position)) blame("the ball left the field");
}

/// Whether a robot stands at the ball in its own goal area's rectangle and arc, or a little beside.
bool Game::mayBeHeld(const WorldState& now) const {
  const FieldGeometry& field = match_.setup.field;
  const Vec2 ball = now.balls.front().position;
  const double margin = match_.setup.ball.radius;
  if (std::abs(ball.x) < field.length / 2 - field.goal_area_depth - field.goal_area_arc_depth - margin ||
      std::abs(ball.y) > field.goal_area_width / 2 + margin) {
    return false;
  }
  const Side side = ball.x < 0.0 ? Side::kLeft : Side::kRight;
  const double reach = std::hypot(match_.setup.robot.length, match_.setup.robot.width) / 2 + margin +
                       match_.setup.rules.keeper.control_gap;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (referee_.state().sideOf(ids_[i].team) == side &&
        distance(now.robots[i].pose.position, ball) <= reach) {
      return true;
    }
  }
  return false;
}

void Game::judge() {
  const WorldState& now = world_->state();
  const PerTeam<int> before = referee_.state().score;
  const bool playing = referee_.state().playing;
  events_.clear();
  const auto call =
      referee_.observe({result_.ticks, ids_, now.robots, now.balls.front(), world_->contacts()}, events_);
  for (const GameEvent& event : events_) {
    ++result_.calls[std::string(event.clause)];
    if (event.margin < 0.0) blame(fmt::format("negative margin of {}", event.clause));
    if (event.clause != clause::kGoal) continue;
    ++result_.goals[now.balls.front().position.x < 0.0 ? 0 : 1];
  }
  checkScore(before);
  ++stopped_;
  if (call) {
    ++result_.restarts;
    ++result_.awarded[nameOf(call->kind)][static_cast<std::size_t>(referee_.state().sideOf(call->team))];
    // Before the signal each false start stops what has hardly begun.
    quick_ = playing && stopped_ < ticksOf(0.25, match_.setup.dt) ? quick_ + 1 : 0;
    if (quick_ > 3) blame("stoppage upon stoppage");
    return begin(*call);
  }
  if (!referee_.state().playing) stuck_.restart(now.balls.front().position, result_.ticks);
  if (referee_.state().period == kShootOutPeriod) return;
  if (mayBeHeld(now)) stuck_.pause();
  if (stuck_.overdue(match_.setup, now.balls.front(), result_.ticks)) blame("a stuck ball was not called");
  result_.longest_stuck = std::max(result_.longest_stuck, result_.ticks - stuck_.since);
}

void Game::tick() {
  drive();
  world_->step(commands_);
  ++result_.ticks;
  checkBodies();
  judge();
}

}  // namespace

RandomMatchResult playRandomMatch(const RandomMatch& match) { return Game(match).play(); }

}  // namespace fulbito::test
