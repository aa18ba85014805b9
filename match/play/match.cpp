#include "fulbito/match.hpp"

#include <algorithm>
#include <utility>

#include "engine/core/base/float_mode.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "match/config/check_match.hpp"
#include "match/play/edit.hpp"
#include "match/play/restart.hpp"
#include "match/seats/seats.hpp"
#include "strategies/interface/team_frame.hpp"

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

/// The call that ended the match, among the calls of its last tick: the reason for the end if there is one,
/// else the last call.
GameEvent endingCall(std::span<const GameEvent> calls) {
  if (calls.empty()) return {};
  if (calls.size() > 1) {
    const GameEvent& before = calls[calls.size() - 2];
    for (const char* clause : {"mercy", "walk-over", "shoot-out"}) {
      if (before.clause == clause) return before;
    }
  }
  return calls.back();
}

}  // namespace

struct Match::Impl {
  Impl(const MatchConfig& from, Seats&& with)
      : config(from),
        referee(refereeSetup(from)),
        misplacing(from.seed, Stream::kPlacement),
        seats(std::move(with)) {
    events.reserve(kRoomForEvents);
    for (const TeamId team : kTeams) {
      auto& origin = config.teams[indexOf(team)].origin;
      for (Setting& entry : seats[team].strategy().origin()) origin.push_back(std::move(entry));
    }
  }

  Result<void> open();
  void advance();

  void ask();
  void build();
  void begin(Play&& from);
  void announce();
  void sense();
  void playTick();
  SeatTick seatTick() const;
  void step();
  std::optional<RestartCall> judge();
  void report();
  void stop(const RestartCall& call);
  void abandon(const Error& error);
  void end(MatchEnd::Reason reason);

  PlacementRequest request(TeamId team) const;
  Moment moment() const;
  GameEvent eventNow() const;
  MatchEnd endOf(TeamId team, MatchEnd::Reason reason) const;

  MatchConfig config;
  MatchPace wait;
  MatchReferee referee;
  Rng misplacing;
  Seats seats;
  MatchPhase phase = MatchPhase::kPlacing;
  std::optional<Placing> placing;  ///< in phases kPlacing and kPlaced
  std::optional<Play> play;        ///< from the first kReady on
  std::vector<WheelSpeeds> commands;
  std::vector<GameEvent> events;  ///< calls of the last tick
  std::vector<MatchObserver*> observers;
  Tick tick = 0;
  StateHash hash;
  std::optional<Error> abandoned;
  StageClock stages;
  int edits = 0;
  bool edited = false;  ///< a user placed the robots, and the teams do not know it yet
  bool begun = false;   ///< the observers know of the match
  bool played = false;  ///< the observers know of the first play
};

Result<void> Match::Impl::open() {
  const RestartCall kick_off = referee.open();
  if (!config.start) {
    placing.emplace(config.opening.value_or(kick_off), GameEvent{});
    return {};
  }
  auto first = makePlay(config, givenStart(config), *config.start);
  if (!first) return fail(first.error().code, "start state: " + first.error().message);
  begin(std::move(*first));
  return {};
}

void Match::Impl::advance() {
  if (phase == MatchPhase::kPlaying && wait) wait(tick + 1);
  stages.begin();
  if (!begun) {
    begun = true;
    for (MatchObserver* observer : observers) observer->onMatchStart(config);
  }
  switch (phase) {
    case MatchPhase::kPlacing:
      return ask();
    case MatchPhase::kPlaced:
      return build();
    case MatchPhase::kReady:
      return announce();
    case MatchPhase::kPlaying:
      return sense();
    case MatchPhase::kDeciding:
      return playTick();
    case MatchPhase::kEnded:
      return;
  }
}

Moment Match::Impl::moment() const {
  if (!play) return {tick, nullptr, {}, &referee.state()};
  return {tick, &play->world.state(), play->ids, &referee.state()};
}

PlacementRequest Match::Impl::request(TeamId team) const {
  PlacementRequest asked = placing->request(referee);
  asked.now = seats[team].before(placing->call(), asked.delay, moment());
  return asked;
}

void Match::Impl::ask() {
  if (const auto team = placing->asked()) placing->answer(seats[*team].place(request(*team)), referee);
  if (!placing->asked()) phase = MatchPhase::kPlaced;
  stages.lap(&MatchProfile::restart);
}

void Match::Impl::build() {
  std::vector<GameEvent> repairs;
  const RestartCall& call = placing->call();
  Placement placement = placing->legalised(referee, repairs);
  misplace(placement, call, referee, config.placement_error, misplacing);
  auto made = makePlay(config, call, placement);
  placing.reset();
  if (!made) return abandon(made.error());
  made->events = std::move(repairs);
  begin(std::move(*made));
  stages.lap(&MatchProfile::restart);
}

void Match::Impl::begin(Play&& from) {
  play.emplace(std::move(from));
  commands.assign(play->ids.size(), {});
  referee.restarted(play->call, play->placement, tick);
  for (const TeamId team : kTeams) seats[team].reset(moment());
  phase = MatchPhase::kReady;
}

void Match::Impl::announce() {
  phase = MatchPhase::kPlaying;
  played = true;
  const Moment now = moment();
  for (const TeamId team : kTeams) seats[team].strategy().ready(seats[team].exactly(now));
  stages.lap(&MatchProfile::restart);
  const PlayStart start{tick,         play->call,       play->placement, play->ids, &play->world.config(),
                        play->events, &referee.state(), edited};
  for (MatchObserver* observer : observers) observer->onPlayStart(start);
  if (edited) ++edits;
  edited = false;
  stages.lap(&MatchProfile::record);
}

GameEvent Match::Impl::eventNow() const {
  const RefereeState& state = referee.state();
  GameEvent event;
  event.tick = tick;
  event.play_time = static_cast<double>(state.play_ticks) * config.physics.controlPeriod();
  event.period = static_cast<std::uint8_t>(state.period);
  if (play) event.place = play->world.state().balls.front().position;
  return event;
}

void Match::Impl::sense() {
  seats.sense(seatTick(), stages);
  phase = MatchPhase::kDeciding;
}

// Decide → navigate → actuate by the seats, then step → referee → record.
void Match::Impl::playTick() {
  events.clear();
  phase = MatchPhase::kPlaying;
  if (auto seated = seats.act(seatTick(), stages, events, commands); !seated) return abandon(seated.error());
  step();
  const auto call = judge();
  const bool over = referee.state().ended;
  report();
  stages.countTick();
  if (over) return end(MatchEnd::Reason::kPlayed);
  if (call) stop(*call);
}

SeatTick Match::Impl::seatTick() const {
  const bool drawn = std::any_of(observers.begin(), observers.end(),
                                 [&](const MatchObserver* o) { return o->wantsDrawings(tick + 1); });
  return {moment(), drawn, config.rules.restart.hold_robots && !referee.state().playing, eventNow()};
}

void Match::Impl::step() {
  play->world.step(commands);
  ++tick;
  hash.add(play->world.state());
  stages.lap(&MatchProfile::step);
}

std::optional<RestartCall> Match::Impl::judge() {
  const WorldState& world = play->world.state();
  const MatchView view{tick, play->ids, world.robots, world.balls.front(), play->world.contacts()};
  for (const TeamId team : kTeams) {
    if (seats[team].lost()) referee.forfeit(team);
  }
  auto call = referee.observe(view, events);
  stages.lap(&MatchProfile::referee);
  return call;
}

void Match::Impl::report() {
  const MatchTick done{tick,
                       play->ids,
                       commands,
                       &play->world.state(),
                       play->world.contacts(),
                       events,
                       &referee.state(),
                       {&seats[TeamId::kBlue].command(), &seats[TeamId::kYellow].command()},
                       {seats[TeamId::kBlue].ways(), seats[TeamId::kYellow].ways()},
                       hash.value()};
  for (MatchObserver* observer : observers) observer->onTick(done);
  stages.lap(&MatchProfile::record);
}

void Match::Impl::stop(const RestartCall& call) {
  // If several calls were made in this tick, the last one stopped play.
  const GameEvent cause = events.empty() ? eventNow() : events.back();
  placing.emplace(call, cause);
  phase = MatchPhase::kPlacing;
  const double delay = placing->delay(referee);
  for (const TeamId team : kTeams) {
    const Side side = referee.state().sideOf(team);
    seats[team].strategy().stopped({inTeamFrame(side, cause), seats[team].before(call, delay, moment())});
  }
  stages.lap(&MatchProfile::restart);
}

void Match::Impl::abandon(const Error& error) {
  abandoned = error;
  if (error.code != ErrorCode::kMachine && error.code != ErrorCode::kInterrupted) {
    abandoned->code = ErrorCode::kBadInput;
  }
  GameEvent event = eventNow();
  event.clause = "match.abandoned";
  event.law = "policy";
  events.assign(1, event);
  for (MatchObserver* observer : observers) observer->onAbandoned(event, referee.state());
  end(MatchEnd::Reason::kAbandoned);
}

MatchEnd Match::Impl::endOf(TeamId team, MatchEnd::Reason reason) const {
  const RefereeState& state = referee.state();
  MatchEnd told;
  told.reason = reason;
  if (reason != MatchEnd::Reason::kInterrupted)
    told.cause = inTeamFrame(state.sideOf(team), endingCall(events));
  told.tick = tick;
  told.own_score = state.score[indexOf(team)];
  told.opponent_score = state.score[indexOf(other(team))];
  if (state.ended) told.winner = state.winner;
  return told;
}

void Match::Impl::end(MatchEnd::Reason reason) {
  phase = MatchPhase::kEnded;
  for (const TeamId team : kTeams) seats[team].strategy().ended(endOf(team, reason));
  for (MatchObserver* observer : observers) observer->onMatchEnd(referee.state(), tick);
}

Match::Match(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Match::Match(Match&&) noexcept = default;
Match& Match::operator=(Match&&) noexcept = default;
Match::~Match() = default;

Result<Match> Match::create(const MatchConfig& config, const MatchClock& clock) {
  const FloatMode floats;
  if (auto checked = checkMatch(config); !checked) return tl::unexpected<Error>(checked.error());
  if (config.decision_time && !clock) {
    return fail(ErrorCode::kUsage, "time per decision: there is no clock to measure it");
  }
  auto seats = Seats::create(config, clock);
  if (!seats) return tl::unexpected<Error>(seats.error());
  auto impl = std::make_unique<Impl>(config, std::move(*seats));
  if (auto opened = impl->open(); !opened) return tl::unexpected<Error>(opened.error());
  return Match(std::move(impl));
}

void Match::watch(MatchObserver& observer) { impl_->observers.push_back(&observer); }

void Match::measure(const MatchClock& now, MatchProfile& profile) { impl_->stages.start(now, profile); }

void Match::pace(MatchPace wait) { impl_->wait = std::move(wait); }

MatchPhase Match::phase() const { return impl_->phase; }

std::optional<AskedTeam> Match::asked() const {
  if (impl_->phase != MatchPhase::kPlacing) return std::nullopt;
  const FloatMode floats;
  const auto team = impl_->placing->asked();
  if (!team) return std::nullopt;
  return AskedTeam{*team, impl_->request(*team)};
}

MatchPhase Match::advance() {
  const FloatMode floats;
  if (impl_->phase != MatchPhase::kEnded) impl_->advance();
  return impl_->phase;
}

MatchPhase Match::makeReady() {
  while (phase() == MatchPhase::kPlacing || phase() == MatchPhase::kPlaced) advance();
  return phase();
}

bool Match::step() {
  if (makeReady() == MatchPhase::kReady) advance();
  if (phase() == MatchPhase::kEnded) return false;
  if (phase() == MatchPhase::kPlaying) advance();
  // The tick and, if it stopped play, the whole restart.
  if (advance() == MatchPhase::kPlacing && makeReady() == MatchPhase::kReady) advance();
  return phase() != MatchPhase::kEnded;
}

void Match::finish() {
  if (!impl_->played && makeReady() == MatchPhase::kReady) advance();
  if (phase() != MatchPhase::kEnded) impl_->end(MatchEnd::Reason::kInterrupted);
}

Placement Match::placement() const { return impl_->play ? placementOf(world(), ids()) : Placement{}; }

Result<void> Match::replace(const Placement& placement) {
  const FloatMode floats;
  Impl& m = *impl_;
  if (m.phase == MatchPhase::kEnded) return fail(ErrorCode::kUsage, "the match is over");
  if (m.placing) return fail(ErrorCode::kUsage, "play is stopped: the teams are asked where they stand");
  if (m.phase == MatchPhase::kDeciding)
    return fail(ErrorCode::kUsage, "the teams have seen this tick, and decide");
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
const WorldState& Match::world() const {
  static const WorldState kNobody{};
  return impl_->play ? impl_->play->world.state() : kNobody;
}
std::span<const RobotId> Match::ids() const {
  return impl_->play ? std::span<const RobotId>(impl_->play->ids) : std::span<const RobotId>();
}
Tick Match::tick() const { return impl_->tick; }
double Match::seconds() const {
  return static_cast<double>(impl_->tick) * impl_->config.physics.controlPeriod();
}
std::uint64_t Match::hash() const { return impl_->hash.value(); }

MatchFaults Match::faults() const {
  const Seats& seats = impl_->seats;
  return {{seats[TeamId::kBlue].faults(), seats[TeamId::kYellow].faults()}, impl_->abandoned};
}

}  // namespace fulbito
