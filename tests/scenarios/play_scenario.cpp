#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"
#include "fulbito/models.hpp"
#include "fulbito/world.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "referee/state/ticks.hpp"
#include "tests/scenarios/scenario.hpp"

namespace fulbito::test {
namespace {

/// An event and the restart that was called in the same tick.
struct Called {
  GameEvent event;
  std::optional<RestartKind> restart;
  std::optional<TeamId> restart_team;
};

Pose2 turned(const Pose2& pose) { return {-pose.position, math::wrapAngle(pose.heading + math::kPi)}; }

/// The scenario with its robots, places and expectations as the variant has them.
Scenario inVariant(Scenario s, ScenarioVariant variant) {
  const auto rotate = [&](Vec2& v) { v = variant.sides ? -v : v; };
  const auto swap = [&](TeamId& team) { team = variant.colours ? other(team) : team; };
  rotate(s.ball), rotate(s.ball_velocity);
  for (ScenarioRobot& r : s.robots) {
    if (variant.sides) r.pose = turned(r.pose);
    rotate(r.velocity), swap(r.id.team);
  }
  for (ScenarioMove& m : s.moves) {
    if (m.robot) swap(m.robot->team);
    if (m.position) rotate(*m.position);
    if (m.velocity) rotate(*m.velocity);
    if (m.heading && variant.sides) m.heading = math::wrapAngle(*m.heading + math::kPi);
  }
  for (ScenarioContact& c : s.contacts) {
    if (c.a) swap(c.a->team);
    if (c.b) swap(c.b->team);
  }
  for (ExpectedEvent& e : s.expected) {
    if (e.team) swap(*e.team);
    if (e.restart_team) swap(*e.restart_team);
  }
  for (ExpectedPlace& p : s.places) {
    rotate(p.position), swap(p.id.team);
  }
  if (variant.colours) std::swap(s.present[0], s.present[1]);
  if (s.score && variant.colours) s.score = Vec2{s.score->y, s.score->x};
  FirstKickOff& first = s.rules.periods.first_kick_off;
  if (variant.colours && first != FirstKickOff::kToss) {
    first = first == FirstKickOff::kBlue ? FirstKickOff::kYellow : FirstKickOff::kBlue;
  }
  return s;
}

RefereeSetup setupOf(const Scenario& s, ScenarioVariant variant, const PhysicsProfile& physics) {
  RefereeSetup setup;
  setup.rules = s.rules;
  setup.field = loadField(s.rules.field).value();
  const RobotPreset robot = loadRobot("vsss").value();
  setup.robot = robot.robot;
  setup.ball = robot.ball;
  setup.dt = physics.controlPeriod();
  setup.blue_side = variant.sides != variant.colours ? Side::kRight : Side::kLeft;
  setup.present = s.present;
  return setup;
}

class Play {
 public:
  Play(const Scenario& s, ScenarioVariant variant)
      : scenario_(s),
        physics_(loadPhysics("standard").value()),
        setup_(setupOf(s, variant, physics_)),
        referee_(setup_) {}

  void run();
  std::string verdict() const;
  std::vector<GameEvent> events() const;

 private:
  void begin();
  void beginFrom(const RestartCall& call, const Placement& placement);
  void act();
  void apply(const ScenarioMove& move);
  void advance();
  void addContacts();
  bool judge();
  std::string describe(const Called& called) const;
  std::size_t find(RobotId id) const;
  double seconds(Tick tick) const { return static_cast<double>(tick) * setup_.dt; }

  const Scenario& scenario_;
  PhysicsProfile physics_;
  RefereeSetup setup_;
  MatchReferee referee_;
  std::optional<World> world_;
  std::vector<RobotId> ids_;
  std::vector<RobotState> robots_;
  BallState ball_;
  std::vector<WheelSpeeds> commands_;
  std::vector<ContactEvent> contacts_;
  std::vector<GameEvent> log_;
  std::vector<Called> called_;
  Tick tick_ = 0;
  std::size_t next_move_ = 0;
};

std::size_t Play::find(RobotId id) const {
  return static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), id) - ids_.begin());
}

void Play::begin() {
  if (scenario_.start == ScenarioStart::kOpening) {
    const RestartCall call = referee_.open();
    beginFrom(call, place(setup_, referee_.state(), call, {}, log_));
    return;
  }
  RestartCall call;
  call.kind = RestartKind::kGiven;
  if (!scenario_.robots.empty()) call.team = scenario_.robots.front().id.team;
  Placement placement;
  placement.ball = scenario_.ball;
  placement.ball_velocity = scenario_.ball_velocity;
  for (const ScenarioRobot& r : scenario_.robots) placement.robots[indexOf(r.id.team)][r.id.number] = r.pose;
  call.defaults = placement;
  beginFrom(call, placement);
  for (const ScenarioRobot& r : scenario_.robots) robots_[find(r.id)].velocity = r.velocity;
}

void Play::beginFrom(const RestartCall& call, const Placement& placement) {
  ids_.clear();
  robots_.clear();
  WorldConfig config{setup_.field, physics_, {}, {}, {}};
  for (const TeamId team : kTeams) {
    for (int i = 0; i < kMaxTeamSize; ++i) {
      const auto& pose = placement.robots[indexOf(team)][static_cast<std::size_t>(i)];
      if (!pose) continue;
      ids_.push_back({team, static_cast<std::uint8_t>(i)});
      robots_.push_back({*pose, {}, 0.0, {}});
      config.robots.push_back({setup_.robot, *pose, {}, 0.0});
    }
  }
  ball_ = {placement.ball, placement.ball_velocity, placement.ball_velocity};
  config.balls.push_back({setup_.ball, ball_.position, ball_.velocity, ball_.spin});
  if (scenario_.mode == ScenarioMode::kPhysics) world_.emplace(World::create(config).value());
  commands_.assign(ids_.size(), {});
  referee_.restarted(call, placement, tick_);
}

void Play::apply(const ScenarioMove& move) {
  if (!move.robot) {
    if (move.position) ball_.position = *move.position;
    if (move.velocity) ball_.velocity = *move.velocity;
    return;
  }
  const std::size_t i = find(*move.robot);
  if (i == ids_.size()) return;
  if (move.wheels) commands_[i] = *move.wheels;
  if (move.position) robots_[i].pose.position = *move.position;
  if (move.heading) robots_[i].pose.heading = *move.heading;
  if (move.velocity) robots_[i].velocity = *move.velocity;
}

/// Moves of time t show in the state of the first tick at or after t.
void Play::act() {
  while (next_move_ < scenario_.moves.size() &&
         ticksOf(scenario_.moves[next_move_].at, setup_.dt) <= tick_ + 1) {
    apply(scenario_.moves[next_move_++]);
  }
}

void Play::advance() {
  contacts_.clear();
  if (world_) {
    act();
    const bool held = !referee_.state().playing && setup_.rules.restart.hold_robots;
    std::vector<WheelSpeeds> commands = commands_;
    if (held) std::fill(commands.begin(), commands.end(), WheelSpeeds{});
    world_->step(commands);
    robots_ = world_->state().robots;
    ball_ = world_->state().balls.front();
    contacts_.assign(world_->contacts().begin(), world_->contacts().end());
  } else {
    for (RobotState& robot : robots_) robot.pose.position += robot.velocity * setup_.dt;
    ball_.position += ball_.velocity * setup_.dt;
    act();
    addContacts();
  }
  ++tick_;
}

void Play::addContacts() {
  for (const ScenarioContact& c : scenario_.contacts) {
    if (tick_ + 1 < ticksOf(c.from, setup_.dt) || tick_ + 1 > ticksOf(c.until, setup_.dt)) continue;
    if (!c.a) {
      const Vec2 normal = nearestWallNormal(setup_.field, ball_.position);
      contacts_.push_back({{BodyKind::kWall, 0},
                           {BodyKind::kBall, 0},
                           ball_.position - normal * setup_.ball.radius,
                           normal,
                           c.impulse,
                           false});
      continue;
    }
    const std::size_t a = find(*c.a);
    const std::size_t b = c.b ? find(*c.b) : 0;
    if (a == ids_.size() || b == ids_.size()) continue;
    const Vec2 from = robots_[a].pose.position, to = c.b ? robots_[b].pose.position : ball_.position;
    contacts_.push_back({{BodyKind::kRobot, static_cast<std::uint16_t>(a)},
                         {c.b ? BodyKind::kRobot : BodyKind::kBall, static_cast<std::uint16_t>(b)},
                         (from + to) / 2,
                         unitOr(to - from, {1.0, 0.0}),
                         c.impulse,
                         false});
  }
}

/// False when the scenario is over.
bool Play::judge() {
  std::vector<GameEvent> events;
  const auto call = referee_.observe({tick_, ids_, robots_, ball_, contacts_}, events);
  for (const GameEvent& event : events) {
    called_.push_back({event, {}, {}});
    if (!call || &event != &events.back()) continue;
    called_.back().restart = call->kind;
    called_.back().restart_team = call->team;
  }
  if (referee_.state().ended) return false;
  if (!call) return true;
  if (!scenario_.goes_on) return false;
  log_.clear();
  beginFrom(*call, place(setup_, referee_.state(), *call, {}, log_));
  for (const GameEvent& event : log_) called_.push_back({event, {}, {}});
  return true;
}

std::string Play::describe(const Called& c) const {
  std::string text = fmt::format("{} at {:.3f} s", c.event.clause, seconds(c.event.tick));
  if (c.event.team) text += fmt::format(" team {}", nameOf(*c.event.team));
  if (c.event.robot) text += fmt::format(" robot {}", *c.event.robot);
  if (c.restart) text += fmt::format(" -> {} for {}", nameOf(*c.restart), nameOf(*c.restart_team));
  return text + fmt::format(" (value {:.4f}, threshold {:.4f})", c.event.value, c.event.threshold);
}

bool fits(const ExpectedEvent& e, const Called& c, double time) {
  constexpr double kEps = 1e-9;
  if (e.clause != c.event.clause || time < e.from - kEps || time > e.until + kEps) return false;
  if (e.team && e.team != c.event.team) return false;
  if (e.robot && *e.robot != (c.event.robot ? *c.event.robot : -1)) return false;
  if (e.restart && e.restart != c.restart) return false;
  return !e.restart_team || e.restart_team == c.restart_team;
}

bool forbidden(const std::string& forbid, std::string_view clause) {
  if (forbid == "*") return true;
  return ("," + forbid + ",").find("," + std::string(clause) + ",") != std::string::npos;
}

std::string Play::verdict() const {
  std::string wrong;
  std::vector<bool> used(called_.size(), false);
  for (const ExpectedEvent& e : scenario_.expected) {
    std::size_t i = 0;
    while (i < called_.size() && (used[i] || !fits(e, called_[i], seconds(called_[i].event.tick)))) ++i;
    if (i == called_.size()) {
      wrong += fmt::format("missing: {} in {} ... {} s\n", e.clause, e.from, e.until);
    } else {
      used[i] = true;
    }
  }
  for (std::size_t i = 0; i < called_.size(); ++i) {
    if (!used[i] && forbidden(scenario_.forbid, called_[i].event.clause)) wrong += "unwanted: ";
    if (!used[i])
      wrong += forbidden(scenario_.forbid, called_[i].event.clause) ? describe(called_[i]) + "\n" : "";
    if (called_[i].event.margin < 0.0) wrong += "negative margin: " + describe(called_[i]) + "\n";
  }
  for (const ExpectedPlace& place : scenario_.places) {
    const std::size_t i = find(place.id);
    constexpr double kRounding = 1e-9;  // [m]
    const Vec2 at = i < robots_.size() ? robots_[i].pose.position : Vec2{1e3, 1e3};
    if (distance(at, place.position) <= kRounding) continue;
    wrong +=
        fmt::format("{} {} stands at ({:.4f}, {:.4f})\n", nameOf(place.id.team), place.id.number, at.x, at.y);
  }
  const PerTeam<int>& score = referee_.state().score;
  if (scenario_.score && (score[0] != scenario_.score->x || score[1] != scenario_.score->y)) {
    wrong += fmt::format("score {}-{}\n", score[0], score[1]);
  }
  return wrong;
}

std::vector<GameEvent> Play::events() const {
  std::vector<GameEvent> events;
  for (const Called& called : called_) events.push_back(called.event);
  return events;
}

void Play::run() {
  begin();
  const Tick end = ticksOf(scenario_.seconds, setup_.dt);
  while (tick_ < end) {
    advance();
    if (!judge()) break;
  }
}

}  // namespace

std::string playScenario(const Scenario& scenario, ScenarioVariant variant) {
  const Scenario changed = inVariant(scenario, variant);
  Play play(changed, variant);
  play.run();
  return play.verdict();
}

std::vector<GameEvent> eventsOf(const Scenario& scenario, ScenarioVariant variant) {
  const Scenario changed = inVariant(scenario, variant);
  Play play(changed, variant);
  play.run();
  return play.events();
}

}  // namespace fulbito::test
