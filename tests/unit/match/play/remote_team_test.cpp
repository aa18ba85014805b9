#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"
#include "strategies/interface/team_frame.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// The messages between a match and a team outside the process, as values.
struct Wire {
  std::string log;  ///< b: begin, p: place, r: ready, d: decisions, s: stopped, e: ended
  MatchInfo info;
  std::vector<PlacementRequest> requests;
  std::vector<Observation> readies, firsts;  ///< `firsts`: the first observation after each ready
  std::vector<PlayStop> stops;
  std::vector<MatchEnd> ends;
  std::optional<TeamProposal> answer;  ///< has arrived, but was not taken yet
  int unanswered = 0;                  ///< placements that were asked for before the answer arrived
};

/// The match's end of the connection.
class Proxy final : public Strategy {
 public:
  explicit Proxy(Wire& wire) : wire_(&wire) {}
  void begin(const MatchInfo& info) override {
    wire_->log += 'b';
    wire_->info = info;
  }
  TeamCommand decide(const Observation& seen) override {
    if (wire_->log.back() != 'd') {
      wire_->log += 'd';
      wire_->firsts.push_back(seen);
    }
    return allWheels({3.0, 5.0});
  }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    wire_->log += 'p';
    wire_->requests.push_back(request);
    if (!wire_->answer) ++wire_->unanswered;
    auto answer = std::move(wire_->answer);
    wire_->answer.reset();
    return answer;
  }
  void stopped(const PlayStop& stop) override {
    wire_->log += 's';
    wire_->stops.push_back(stop);
  }
  void ready(const Observation& seen) override {
    wire_->log += 'r';
    wire_->readies.push_back(seen);
  }
  void ended(const MatchEnd& end) override {
    wire_->log += 'e';
    wire_->ends.push_back(end);
  }

 private:
  Wire* wire_;
};

TeamChoice over(Wire& wire) {
  return TeamChoice::own("remote", [&wire] { return std::make_unique<Proxy>(wire); });
}

/// The team's end: thinks for a few polls about each placement.
class Client {
 public:
  bool answered(const PlacementRequest& request, Wire& wire) {
    ++polls;
    if (++thinking_ < 5) return false;
    thinking_ = 0;
    TeamPlacement wish = request.defaults;
    wish[2] = Pose2{{-0.6, 0.5 - 0.1 * static_cast<double>(polls % 3)}, 0.0};
    wire.answer = wish;
    return true;
  }
  int polls = 0;

 private:
  int thinking_ = 0;
};

/// Plays phase by phase and waits for the client wherever `wire`'s team is asked.
void playWaiting(Match& match, TeamId team, Client& client, Wire& wire) {
  while (match.phase() != MatchPhase::kEnded) {
    if (const auto asked = match.asked(); asked && asked->team == team) {
      while (!client.answered(asked->request, wire)) {
      }
    }
    match.advance();
  }
}

MatchConfig remoteMatch(Wire& wire, TeamId team) {
  MatchConfig config = shortMatch("chaser", "chaser", 40.0);
  config.teams[indexOf(team)] = over(wire);
  config.rules.restart.delay = config.rules.restart.goal_delay = 0.0;
  config.placement_error = {0.0, 0.0};
  return config;
}

/// Whether the calls came in the order that a team may rely on.
bool inOrder(const std::string& log) {
  if (log.size() < 4 || log.front() != 'b' || log.back() != 'e') return false;
  for (std::size_t i = 1; i + 1 < log.size(); ++i) {
    const std::string pairs[] = {"bp", "pr", "rd", "ds", "sp", "de"};
    if (std::find(std::begin(pairs), std::end(pairs), log.substr(i - 1, 2)) == std::end(pairs)) return false;
  }
  return true;
}

struct Plays final : MatchObserver {
  std::string calls;
  std::vector<GameEvent> events;
  std::vector<Placement> before;  ///< where all bodies were when play stopped, in the world's frame
  std::vector<Placement> placements;
  std::vector<RefereeState> referees;
  const Match* match = nullptr;
  Placement last;
  void onMatchStart(const MatchConfig&) override { calls += 'm'; }
  void onPlayStart(const PlayStart& start) override {
    calls += 'p';
    if (start.tick > 0) before.push_back(last);
    placements.push_back(start.placement);
    referees.push_back(*start.referee);
  }
  void onTick(const MatchTick& tick) override {
    last = match->placement();
    for (const GameEvent& event : tick.events) events.push_back(event);
  }
  void onAbandoned(const GameEvent& event, const RefereeState&) override {
    calls += 'a';
    events.push_back(event);
  }
  void onMatchEnd(const RefereeState&, Tick) override { calls += 'e'; }
};

}  // namespace

TEST_CASE("a team outside the process is waited for, with the same match as one inside", "[unit]") {
  const TeamId team = GENERATE(TeamId::kBlue, TeamId::kYellow);
  Wire wire;
  Client client;
  auto match = Match::create(remoteMatch(wire, team));
  REQUIRE(match);
  playWaiting(*match, team, client, wire);
  CHECK(wire.unanswered == 0);
  CHECK(inOrder(wire.log));
  CHECK(wire.requests.size() > 2);
  CHECK(wire.readies.size() == wire.requests.size());
  CHECK(wire.stops.size() + 1 == wire.requests.size());
  CHECK(client.polls == 5 * static_cast<int>(wire.requests.size()));

  // The same, with answers at once in `step`.
  Client again;
  const TestEntry inside([](const Observation&) { return allWheels({3.0, 5.0}); },
                         [&again](const PlacementRequest& request) {
                           Wire local;
                           while (!again.answered(request, local)) {
                           }
                           return local.answer;
                         });
  MatchConfig config = remoteMatch(wire, team);
  config.teams[indexOf(team)] = inside.choice();
  CHECK(hashOf(config) == match->hash());
}

TEST_CASE("new positions are seen before the first command, also where play begins at once", "[unit]") {
  Wire wire;
  Client client;
  MatchConfig config = remoteMatch(wire, TeamId::kYellow);
  config.vision[indexOf(TeamId::kYellow)] = {4, 0.01, 0.1, 0.5};
  auto match = Match::create(config);
  REQUIRE(match);
  Plays plays;
  plays.match = &*match;
  match->watch(plays);
  playWaiting(*match, TeamId::kYellow, client, wire);
  REQUIRE(wire.readies.size() == plays.placements.size());
  REQUIRE(wire.readies.size() > 2);
  for (std::size_t i = 0; i < wire.readies.size(); ++i) {
    const Observation& ready = wire.readies[i];
    const Side side = plays.referees[i].sideOf(TeamId::kYellow);
    CHECK(ready.since_restart == 0.0);
    CHECK(ready.playing);
    CHECK(ready.restart == plays.referees[i].last.kind);
    CHECK(ready.tick == wire.firsts[i].tick + 4);  // the first picture of the play is older
    CHECK(ready.own_score == plays.referees[i].score[1]);
    for (std::size_t n = 0; n < 3; ++n) {
      const Vec2 own = inTeamFrame(side, plays.placements[i].robots[1][n]->position);
      const Vec2 theirs = inTeamFrame(side, plays.placements[i].robots[0][n]->position);
      CHECK(distance(ready.own[n].state.pose.position, own) < 1e-6);
      CHECK(distance(ready.opponents[n].state.pose.position, theirs) < 1e-6);
    }
  }
}

TEST_CASE("a team is told why play stopped and how the match stands", "[unit]") {
  const TeamId team = GENERATE(TeamId::kBlue, TeamId::kYellow);
  Wire wire;
  Client client;
  MatchConfig config = remoteMatch(wire, team);
  config.rules.restart.delay = 0.5;
  config.rules.restart.goal_delay = 1.0;
  config.rules.half_seconds = 120.0;  // long enough for a goal
  auto match = Match::create(config);
  REQUIRE(match);
  Plays plays;
  plays.match = &*match;
  match->watch(plays);
  playWaiting(*match, team, client, wire);
  REQUIRE(wire.stops.size() == plays.before.size());
  int goals = 0, halves = 0;
  for (std::size_t i = 0; i < wire.stops.size(); ++i) {
    const PlayStop& stop = wire.stops[i];
    const PlacementRequest& request = wire.requests[i + 1];
    const RefereeState& referee = plays.referees[i + 1];
    const Side side = referee.sideOf(team);
    CHECK(request.cause.clause == stop.cause.clause);
    CHECK(request.now.tick == stop.now.tick);
    CHECK(request.now.tick == request.cause.tick);
    CHECK(request.now.period == referee.period);
    CHECK(request.now.own_score == referee.score[indexOf(team)]);
    CHECK(request.now.opponent_score == referee.score[indexOf(other(team))]);
    CHECK(request.now.restart == request.kind);
    CHECK(request.now.restart_is_ours == request.ours);
    CHECK(request.now.since_restart == -request.delay);
    CHECK_FALSE(request.now.playing);
    CHECK(request.delay == Approx(request.cause.clause == "goal" ? 1.0 : 0.5));
    CHECK(wire.readies[i + 1].since_restart == Approx(-request.delay));
    // The frame is that of the next play: after half-time the other half of the field.
    CHECK(distance(request.now.ball.position, inTeamFrame(side, plays.before[i].ball)) < 1e-9);
    CHECK(distance(request.cause.place, request.now.ball.position) < 1e-9);
    for (std::size_t n = 0; n < 3; ++n) {
      REQUIRE(request.now.own[n].present);
      const Vec2 own = inTeamFrame(side, plays.before[i].robots[indexOf(team)][n]->position);
      CHECK(distance(request.now.own[n].state.pose.position, own) < 1e-9);
    }
    goals += stop.cause.clause == "goal" ? 1 : 0;
    halves += stop.cause.clause == "half" ? 1 : 0;
  }
  CHECK(goals > 0);
  CHECK(halves == 1);
}

TEST_CASE("the first placement is asked for after `create`, and whoever watches sees it", "[unit]") {
  Wire wire;
  auto match = Match::create(remoteMatch(wire, TeamId::kBlue));
  REQUIRE(match);
  CHECK(wire.log == "b");
  CHECK(match->phase() == MatchPhase::kPlacing);
  CHECK(match->ids().empty());
  CHECK(match->world().robots.empty());
  CHECK_FALSE(match->placement().robots[0][0]);
  CHECK_FALSE(match->replace(twoColumns()));  // there is nothing to be replaced yet
  Plays plays;
  plays.match = &*match;
  match->watch(plays);
  std::string order;
  while (match->phase() != MatchPhase::kPlaying) {
    order += std::to_string(static_cast<int>(match->phase()));
    if (const auto asked = match->asked()) {
      CHECK(asked->request.cause.clause.empty());
      CHECK(asked->request.now.tick == 0);
      CHECK_FALSE(asked->request.now.own[0].present);
      CHECK(asked->request.opponents.has_value() != asked->request.ours);
    }
    match->advance();
    CHECK(plays.calls.front() == 'm');
  }
  CHECK(order == "0012");
  CHECK(wire.log == "bpr");
  CHECK(plays.calls == "mp");
  CHECK(match->ids().size() == 6);
  CHECK(match->tick() == 0);
  CHECK(match->advance() == MatchPhase::kDeciding);
  CHECK(wire.log == "bpr");
  CHECK(match->tick() == 0);
  CHECK(match->advance() == MatchPhase::kPlaying);
  CHECK(wire.log == "bprd");
  CHECK(match->tick() == 1);
}

TEST_CASE("who makes a match ready looks at it, and nothing changes", "[unit]") {
  const MatchConfig config = shortMatch();
  auto match = Match::create(config);
  REQUIRE(match);
  Plays plays;
  plays.match = &*match;
  match->watch(plays);
  CHECK(match->makeReady() == MatchPhase::kReady);
  CHECK(match->makeReady() == MatchPhase::kReady);
  CHECK(match->ids().size() == 6);
  CHECK(plays.calls == "m");
  while (match->step()) {
  }
  CHECK(match->makeReady() == MatchPhase::kEnded);
  CHECK(match->hash() == hashOf(config));
  CHECK(plays.calls.substr(0, 2) == "mp");
}

TEST_CASE("a team is told once how the match ended", "[unit]") {
  Wire wire;
  Client client;
  MatchConfig config = remoteMatch(wire, TeamId::kYellow);
  SECTION("by the clock") {
    auto match = Match::create(config);
    REQUIRE(match);
    playWaiting(*match, TeamId::kYellow, client, wire);
    match->finish();
    REQUIRE(wire.ends.size() == 1);
    CHECK(wire.ends[0].reason == MatchEnd::Reason::kPlayed);
    CHECK(wire.ends[0].cause.clause == "full-time");
    CHECK(wire.ends[0].own_score == match->referee().score[1]);
    CHECK(wire.ends[0].opponent_score == match->referee().score[0]);
    CHECK(wire.ends[0].winner == match->referee().winner);
    CHECK(wire.ends[0].tick == match->tick());
  }
  SECTION("by a lead") {
    config.rules.periods.mercy_goals = 1;
    config.rules.half_seconds = 120.0;  // long enough for a goal
    auto match = Match::create(config);
    REQUIRE(match);
    playWaiting(*match, TeamId::kYellow, client, wire);
    REQUIRE(wire.ends.size() == 1);
    CHECK(wire.ends[0].cause.clause == "mercy");
    CHECK(wire.ends[0].winner.has_value());
  }
}

TEST_CASE("a team is told once of an end before the time", "[unit]") {
  Wire wire;
  MatchConfig config = remoteMatch(wire, TeamId::kYellow);
  SECTION("by whoever ran it") {
    auto match = Match::create(config);
    REQUIRE(match);
    for (int i = 0; i < 10; ++i) REQUIRE(match->step());
    match->finish();
    match->finish();
    REQUIRE(wire.ends.size() == 1);
    CHECK(wire.ends[0].reason == MatchEnd::Reason::kInterrupted);
    CHECK(wire.ends[0].cause.clause.empty());
    CHECK_FALSE(wire.ends[0].winner);
    CHECK(wire.ends[0].tick == 10);
  }
  SECTION("as no world can be made") {
    RestartCall call;
    call.kind = RestartKind::kGiven;
    call.defaults.ball = {3.0, 0.0};
    config.opening = call;
    auto match = Match::create(config);
    REQUIRE(match);
    Plays plays;
    EventLog log;
    plays.match = &*match;
    match->watch(plays);
    match->watch(log);
    CHECK_FALSE(match->step());
    REQUIRE(match->faults().abandoned);
    CHECK(match->faults().abandoned->message == "ball 0: position (3, 0) is outside the field");
    CHECK(plays.calls == "mae");
    REQUIRE(wire.ends.size() == 1);
    CHECK(wire.ends[0].reason == MatchEnd::Reason::kAbandoned);
    CHECK(wire.ends[0].cause.clause == "match.abandoned");
    REQUIRE(log.events().size() == 1);
    CHECK(log.events()[0].call.clause == "match.abandoned");
  }
}

TEST_CASE("a team is told where a user put everybody", "[unit]") {
  Wire wire;
  auto match = Match::create(remoteMatch(wire, TeamId::kBlue));
  REQUIRE(match);
  for (int i = 0; i < 10; ++i) REQUIRE(match->step());
  Placement wanted = match->placement();
  wanted.ball = {0.1, 0.55};
  REQUIRE(match->replace(wanted));
  CHECK(match->phase() == MatchPhase::kReady);
  REQUIRE(match->step());
  CHECK(wire.log == "bprdrd");
  REQUIRE(wire.readies.size() == 2);
  CHECK(wire.readies[1].restart == RestartKind::kGiven);
  CHECK(distance(wire.readies[1].ball.position, {0.1, 0.55}) < 1e-6);
}

TEST_CASE("a team is told its seat and what is played before the match", "[unit]") {
  for (const TeamId team : kTeams) {
    Wire wire;
    MatchConfig config = remoteMatch(wire, team);
    config.vision[indexOf(team)] = {6, 0.002, 0.03, 0.1};
    config.decision_time = DecisionTime{0.01, 1.0, 5};
    config.rules.periods.overtime_seconds = 77.0;
    config.seed = 12;
    REQUIRE(Match::create(config, [] { return std::int64_t{0}; }));
    const MatchInfo& info = wire.info;
    CHECK(info.team == team);
    CHECK(info.side == (team == TeamId::kBlue ? Side::kLeft : Side::kRight));
    CHECK(info.rules.half_seconds == 40.0);
    CHECK(info.rules.periods.overtime_seconds == 77.0);
    CHECK(info.dt() == Approx(1.0 / 60.0));
    CHECK(info.observation_age == Approx(0.1));
    CHECK(info.position_noise == 0.002);
    CHECK(info.heading_noise == 0.03);
    CHECK(info.dropout == 0.1);
    CHECK(info.seed == 24 + indexOf(team));
    REQUIRE(info.decision_time);
    CHECK(info.decision_time->decision == 0.01);
  }
}

TEST_CASE("ticks go by a clock outside, each told which one it is", "[unit]") {
  std::vector<Tick> told;
  const MatchConfig config = shortMatch("chaser", "chaser", 2.0);
  auto match = Match::create(config);
  REQUIRE(match);
  match->pace([&](Tick next) { told.push_back(next); });
  match->makeReady();
  CHECK(told.empty());
  while (match->step()) {
  }
  REQUIRE(told.size() == static_cast<std::size_t>(match->tick()));
  for (std::size_t i = 0; i < told.size(); ++i) REQUIRE(told[i] == static_cast<Tick>(i) + 1);
  CHECK(match->hash() == hashOf(config));
}

}  // namespace fulbito
