#include "match/match.hpp"

#include "engine/core/hash.hpp"
#include "strategies/team_frame.hpp"
#include "strategies/team_pilots.hpp"

namespace fulbito {
namespace {

MatchInfo infoOf(const MatchConfig& config, TeamId team) {
  MatchInfo info;
  info.field = config.field;
  info.robot = config.robot.robot;
  info.ball = config.robot.ball;
  info.physics = config.physics;
  info.team_size = config.rules.team_size;
  info.half_seconds = config.rules.half_seconds;
  info.observation_age = config.vision.latency_ticks * config.physics.controlPeriod();
  info.position_noise = config.vision.position_noise;
  info.seed = config.seed * 2 + indexOf(team);
  return info;
}

RefereeSetup setupOf(const MatchConfig& config) {
  RefereeSetup setup;
  setup.rules = config.rules;
  setup.field = config.field;
  setup.robot = config.robot.robot;
  setup.ball = config.robot.ball;
  setup.dt = config.physics.controlPeriod();
  setup.seed = config.seed;
  return setup;
}

/// A team with its navigation stage and its last decision.
struct Seat {
  std::unique_ptr<Strategy> strategy;
  TeamPilots pilots;
  Observation observation;
  TeamCommand command;
};

}  // namespace

struct Match::Impl {
  explicit Impl(const MatchConfig& c) : config(c), referee(setupOf(c)) {}

  Side sideOf(TeamId team) const {
    const Side blue = referee.state().blue_side;
    return team == TeamId::kBlue ? blue : opposite(blue);
  }
  void begin(const RestartCall& call);
  void observe(TeamId team);
  void actuate(TeamId team, const std::array<WheelSpeeds, kMaxTeamSize>& wheels);

  MatchConfig config;
  MatchReferee referee;
  std::vector<Seat> seats;
  std::optional<World> world;
  std::vector<RobotId> ids;
  std::vector<WheelSpeeds> commands;
  std::vector<GameEvent> events;
  std::vector<MatchObserver*> observers;
  Tick tick = 0;
  StateHash hash;
  bool begun = false;
  bool ended = false;
};

void Match::Impl::begin(const RestartCall& call) {
  events.clear();
  const Placement& placement = call.defaults;
  WorldConfig setup;
  setup.field = config.field;
  setup.physics = config.physics;
  ids.clear();
  for (const TeamId team : kTeams) {
    for (int i = 0; i < config.rules.team_size; ++i) {
      const auto& pose = placement.robots[indexOf(team)][static_cast<std::size_t>(i)];
      if (!pose) continue;
      ids.push_back({team, static_cast<std::uint8_t>(i)});
      setup.robots.push_back({config.robot.robot, *pose, {}, 0.0});
    }
  }
  setup.balls.push_back({config.robot.ball, placement.ball, placement.ball_velocity, {}});
  auto made = World::create(setup);
  if (!made) return;
  world.emplace(std::move(*made));
  commands.assign(ids.size(), {});
  for (Seat& seat : seats) seat.pilots.reset();
  referee.restarted(call, placement, tick);
  const PlayStart start{tick, call, placement, ids, &world->config(), events, &referee.state()};
  for (MatchObserver* observer : observers) observer->playBegins(start);
}

void Match::Impl::observe(TeamId team) {
  Observation& seen = seats[indexOf(team)].observation;
  const RefereeState& state = referee.state();
  const Side side = sideOf(team);
  const WorldState& now = world->state();
  seen.tick = tick;
  seen.dt = config.physics.controlPeriod();
  seen.team_size = config.rules.team_size;
  for (auto* robots : {&seen.own, &seen.opponents}) {
    for (ObservedRobot& robot : *robots) robot.present = false;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    auto& robots = ids[i].team == team ? seen.own : seen.opponents;
    ObservedRobot& robot = robots[ids[i].number];
    robot.present = true;
    robot.state = inTeamFrame(side, now.robots[i]);
    if (ids[i].team != team) robot.state.wheels = {};
  }
  seen.ball = inTeamFrame(side, now.balls.front());
  seen.ball.spin = {};
  seen.playing = state.playing;
  seen.restart = state.last.kind;
  seen.restart_is_ours = state.last.team == team;
  seen.since_restart = static_cast<double>(tick - state.play_began) * seen.dt;
  seen.period = state.period;
  seen.remaining = config.rules.half_seconds - static_cast<double>(state.play_ticks) * seen.dt;
  seen.own_score = state.score[indexOf(team)];
  seen.opponent_score = state.score[indexOf(other(team))];
}

void Match::Impl::actuate(TeamId team, const std::array<WheelSpeeds, kMaxTeamSize>& wheels) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i].team != team) continue;
    commands[i] =
        roundedTo(saturate(config.robot.robot, wheels[ids[i].number]), config.physics.wheel_command_step);
  }
}

Match::Match(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Match::Match(Match&&) noexcept = default;
Match& Match::operator=(Match&&) noexcept = default;
Match::~Match() = default;

Result<Match> Match::create(const MatchConfig& config) {
  auto impl = std::make_unique<Impl>(config);
  for (const TeamId team : kTeams) {
    auto strategy = makeTeam(config.teams[indexOf(team)]);
    if (!strategy) return tl::unexpected<Error>(strategy.error());
    const MatchInfo info = infoOf(config, team);
    (*strategy)->begin(info);
    auto pilots = TeamPilots::create(info, (*strategy)->navigators());
    if (!pilots) return tl::unexpected<Error>(pilots.error());
    impl->seats.push_back({std::move(*strategy), std::move(*pilots), {}, {}});
  }
  return Match(std::move(impl));
}

void Match::watch(MatchObserver& observer) { impl_->observers.push_back(&observer); }
void Match::measure(const MatchClock&, MatchProfile&) {}

bool Match::step() {
  Impl& m = *impl_;
  if (m.ended) return false;
  if (!m.begun) {
    m.begun = true;
    for (MatchObserver* observer : m.observers) observer->matchBegins(m.config);
    m.begin(m.referee.open());
  }
  for (const TeamId team : kTeams) m.observe(team);
  for (const TeamId team : kTeams) {
    Seat& seat = m.seats[indexOf(team)];
    seat.command = seat.strategy->decide(seat.observation);
    m.actuate(team, seat.pilots.drive(seat.observation, seat.command));
  }
  m.world->step(m.commands);
  ++m.tick;
  m.hash.add(m.world->state());
  m.events.clear();
  const MatchView view{m.tick, m.ids, m.world->state().robots, m.world->state().balls.front(),
                       m.world->contacts()};
  const auto call = m.referee.observe(view, m.events);
  const MatchTick done{m.tick,
                       m.ids,
                       m.commands,
                       &m.world->state(),
                       m.world->contacts(),
                       m.events,
                       &m.referee.state(),
                       {&m.seats[0].command, &m.seats[1].command}};
  for (MatchObserver* observer : m.observers) observer->ticked(done);
  if (m.referee.state().ended) {
    finish();
    return false;
  }
  if (call) m.begin(*call);
  return true;
}

void Match::finish() {
  if (impl_->ended) return;
  impl_->ended = true;
  for (MatchObserver* observer : impl_->observers) observer->matchEnds(impl_->referee.state(), impl_->tick);
}

const RefereeState& Match::referee() const { return impl_->referee.state(); }
const WorldState& Match::world() const { return impl_->world->state(); }
Tick Match::tick() const { return impl_->tick; }
std::uint64_t Match::hash() const { return impl_->hash.value(); }

}  // namespace fulbito
