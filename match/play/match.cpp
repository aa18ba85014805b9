#include "match/play/match.hpp"

#include <algorithm>
#include <utility>

#include "engine/core/base/float_mode.hpp"
#include "engine/core/base/hash.hpp"
#include "match/config/check_match.hpp"
#include "match/play/edit.hpp"
#include "match/play/restart.hpp"
#include "match/play/stage_clock.hpp"
#include "match/seats/seat.hpp"

namespace fulbito {

RefereeSetup refereeSetup(const MatchConfig& config) {
  RefereeSetup setup;
  setup.rules = config.rules;
  setup.field = config.field;
  setup.robot = config.robot.robot;
  setup.ball = config.robot.ball;
  setup.dt = config.physics.controlPeriod();
  setup.seed = config.seed;
  setup.present = config.present;
  setup.scoreboard = config.scoreboard;
  return setup;
}

namespace {

constexpr std::size_t kRoomForEvents = 64;

RestartCall givenStart(const MatchConfig& config) {
  const Placement& placement = *config.start;
  RestartCall call;
  call.kind = config.opening ? config.opening->kind : RestartKind::kGiven;
  if (config.opening) call.team = config.opening->team;
  call.ball = placement.ball;
  call.defaults = placement;
  return call;
}

}  // namespace

struct Match::Impl {
  explicit Impl(const MatchConfig& from)
      : config(from), referee(refereeSetup(from)), misplacing(from.seed, Stream::kPlacement) {
    events.reserve(kRoomForEvents);
    seats.reserve(kTeams.size());
  }

  Result<void> open();
  void start();
  void announce();
  void sense();
  void decide();
  void advance();
  std::optional<RestartCall> judge();
  void prepare(const RestartCall& call);
  void report();
  void begin(Play&& play);

  Result<Play> placed(RestartCall call);
  Moment moment() const { return {tick, &play->world.state(), play->ids, &referee.state()}; }
  GameEvent eventNow() const;

  MatchConfig config;
  MatchReferee referee;
  Rng misplacing;
  std::vector<Seat> seats;
  std::optional<Play> play;
  std::optional<Play> next;  ///< the play that follows the tick which is being reported
  std::vector<WheelSpeeds> commands;
  std::vector<GameEvent> events;
  std::vector<MatchObserver*> observers;
  Tick tick = 0;
  StateHash hash;
  std::optional<Error> abandoned;
  StageClock stages;
  MatchClock watchdog;
  std::int64_t decision_limit = 0;
  int edits = 0;
  bool edited = false;  ///< the play is a user's, of which nobody was told yet
  bool started = false;
  bool ended = false;
};

Result<Play> Match::Impl::placed(RestartCall call) {
  std::vector<GameEvent> repairs;
  Placement placement = placementOf(call, referee, {&seats[0].strategy(), &seats[1].strategy()}, repairs);
  misplace(placement, call, referee, config.placement_error, misplacing);
  auto made = makePlay(config, call, placement);
  if (made) made->events = std::move(repairs);
  return made;
}

Result<void> Match::Impl::open() {
  const RestartCall kick_off = referee.open();
  auto first = config.start ? makePlay(config, givenStart(config), *config.start)
                            : placed(config.opening.value_or(kick_off));
  if (!first) {
    return fail(first.error().code,
                (config.start ? "start state: " : "first restart: ") + first.error().message);
  }
  begin(std::move(*first));
  return {};
}

void Match::Impl::begin(Play&& from) {
  play.emplace(std::move(from));
  commands.assign(play->ids.size(), {});
  referee.restarted(play->call, play->placement, tick);
  for (Seat& seat : seats) seat.reset(moment());
}

void Match::Impl::announce() {
  const PlayStart start{tick,         play->call,       play->placement, play->ids, &play->world.config(),
                        play->events, &referee.state(), edited};
  for (MatchObserver* observer : observers) observer->playBegins(start);
  stages.lap(&MatchProfile::record);
}

void Match::Impl::start() {
  if (started && !edited) return;
  if (!started) {
    for (MatchObserver* observer : observers) observer->matchBegins(config);
  }
  started = true;
  announce();
  if (edited) ++edits;
  edited = false;
}

GameEvent Match::Impl::eventNow() const {
  const RefereeState& state = referee.state();
  GameEvent event;
  event.tick = tick;
  event.play_time = static_cast<double>(state.play_ticks) * config.physics.controlPeriod();
  event.period = static_cast<std::uint8_t>(state.period);
  event.place = play->world.state().balls.front().position;
  return event;
}

void Match::Impl::sense() {
  const Moment now = moment();
  const bool drawn = std::any_of(observers.begin(), observers.end(),
                                 [&](const MatchObserver* o) { return o->wantsDrawings(tick + 1); });
  for (Seat& seat : seats) {
    seat.sense(now);
    seat.wantDrawings(drawn);
  }
  stages.lap(&MatchProfile::sense);
}

void Match::Impl::decide() {
  const GameEvent now = eventNow();
  for (Seat& seat : seats) {
    const std::int64_t begun = watchdog ? watchdog() : 0;
    TeamCommand decision = seat.decide();
    const bool late = watchdog && watchdog() - begun > decision_limit;
    stages.lap(&MatchProfile::decide);
    seat.policy().take(std::move(decision), late, now, events);
    stages.lap(&MatchProfile::navigate);
  }
}

void Match::Impl::advance() {
  PerTeam<std::array<WheelSpeeds, kMaxTeamSize>> wheels;
  for (const TeamId team : kTeams) wheels[indexOf(team)] = seats[indexOf(team)].drive();
  const bool held = config.rules.restart.hold_robots && !referee.state().playing;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const RobotId id = play->ids[i];
    Seat& seat = seats[indexOf(id.team)];
    commands[i] = held ? WheelSpeeds{} : seat.policy().actuated(wheels[indexOf(id.team)][id.number]);
    seat.told(id.number, commands[i]);
  }
  stages.lap(&MatchProfile::navigate);
  play->world.step(commands);
  ++tick;
  hash.add(play->world.state());
  stages.lap(&MatchProfile::step);
}

std::optional<RestartCall> Match::Impl::judge() {
  const WorldState& world = play->world.state();
  const MatchView view{tick, play->ids, world.robots, world.balls.front(), play->world.contacts()};
  auto call = referee.observe(view, events);
  stages.lap(&MatchProfile::referee);
  return call;
}

void Match::Impl::prepare(const RestartCall& call) {
  auto made = placed(call);
  if (made) {
    next.emplace(std::move(*made));
  } else {
    abandoned = made.error();
    GameEvent event = eventNow();
    event.clause = "match.abandoned";
    event.law = "policy";
    events.push_back(event);
  }
  stages.lap(&MatchProfile::restart);
}

void Match::Impl::report() {
  const MatchTick done{tick,
                       play->ids,
                       commands,
                       &play->world.state(),
                       play->world.contacts(),
                       events,
                       &referee.state(),
                       {&seats[0].policy().command(), &seats[1].policy().command()},
                       {seats[0].ways(), seats[1].ways()},
                       hash.value()};
  for (MatchObserver* observer : observers) observer->ticked(done);
  stages.lap(&MatchProfile::record);
}

Match::Match(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Match::Match(Match&&) noexcept = default;
Match& Match::operator=(Match&&) noexcept = default;
Match::~Match() = default;

Result<Match> Match::create(const MatchConfig& config) {
  const FloatMode floats;
  if (auto checked = checkMatch(config); !checked) return tl::unexpected<Error>(checked.error());
  auto impl = std::make_unique<Impl>(config);
  for (const TeamId team : kTeams) {
    auto seat = Seat::create(config, team);
    if (!seat) {
      return fail(seat.error().code, std::string(nameOf(team)) + " team: " + seat.error().message);
    }
    impl->seats.push_back(std::move(*seat));
  }
  if (auto opened = impl->open(); !opened) return tl::unexpected<Error>(opened.error());
  return Match(std::move(impl));
}

void Match::watch(MatchObserver& observer) { impl_->observers.push_back(&observer); }

void Match::measure(const MatchClock& now, MatchProfile& profile) { impl_->stages.start(now, profile); }

void Match::limitDecisionTime(const MatchClock& now, std::int64_t limit) {
  impl_->watchdog = now;
  impl_->decision_limit = limit;
}

bool Match::step() {
  const FloatMode floats;
  Impl& m = *impl_;
  if (m.ended) return false;
  m.stages.begin();
  m.start();
  m.events.clear();
  m.sense();
  m.decide();
  m.advance();
  const auto call = m.judge();
  const bool over = m.referee.state().ended;
  if (call && !over) m.prepare(*call);
  m.report();
  m.stages.countTick();
  if (over || m.abandoned) {
    finish();
    return false;
  }
  if (m.next) {
    m.begin(std::move(*m.next));
    m.next.reset();
    m.stages.lap(&MatchProfile::restart);
    m.announce();
  }
  return true;
}

void Match::finish() {
  if (impl_->ended) return;
  if (!impl_->started) impl_->start();
  impl_->ended = true;
  for (MatchObserver* observer : impl_->observers) observer->matchEnds(impl_->referee.state(), impl_->tick);
}

Placement Match::placement() const { return placementOf(world(), ids()); }

Result<void> Match::replace(const Placement& placement) {
  const FloatMode floats;
  Impl& m = *impl_;
  if (m.ended) return fail(ErrorCode::kUsage, "the match is over");
  if (const auto flaw = flawOfEdit(m.config, this->placement(), placement)) {
    return fail(ErrorCode::kUsage, *flaw);
  }
  auto play = makePlay(m.config, editCall(m.referee.state(), placement), placement);
  if (!play) return tl::unexpected<Error>(play.error());
  m.begin(std::move(*play));
  m.edited = true;
  return {};
}

int Match::edits() const { return impl_->edits; }

const MatchConfig& Match::config() const { return impl_->config; }
const RefereeState& Match::referee() const { return impl_->referee.state(); }
const WorldState& Match::world() const { return impl_->play->world.state(); }
std::span<const RobotId> Match::ids() const { return impl_->play->ids; }
Tick Match::tick() const { return impl_->tick; }
double Match::seconds() const {
  return static_cast<double>(impl_->tick) * impl_->config.physics.controlPeriod();
}
std::uint64_t Match::hash() const { return impl_->hash.value(); }

MatchFaults Match::faults() const {
  return {{impl_->seats[0].policy().faults(), impl_->seats[1].policy().faults()}, impl_->abandoned};
}

}  // namespace fulbito
