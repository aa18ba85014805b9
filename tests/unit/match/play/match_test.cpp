#include "fulbito/match.hpp"

#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Records the calls to an observer and their arguments.
struct Diary final : MatchObserver {
  std::string calls;
  std::vector<Placement> placements;
  std::vector<Tick> starts;
  std::vector<std::uint64_t> hashes;
  std::vector<std::string> clauses;

  void onMatchStart(const MatchConfig&) override { calls += 'm'; }
  void onPlayStart(const PlayStart& start) override {
    calls += 'p';
    placements.push_back(start.placement);
    starts.push_back(start.tick);
  }
  void onTick(const MatchTick& tick) override {
    if (calls.back() != 't') calls += 't';
    hashes.push_back(tick.hash);
    for (const GameEvent& event : tick.events) clauses.emplace_back(event.clause);
  }
  void onMatchEnd(const RefereeState&, Tick) override { calls += 'e'; }
};

using Notes = std::vector<std::pair<Tick, int>>;

/// A built-in team that notes one number that it sees, by tick.
class Noting final : public Strategy {
 public:
  Noting(const std::string& name, int Observation::* number, Notes& notes)
      : team_(*makeTeam(*parseTeam(name))), number_(number), notes_(&notes) {}
  void begin(const MatchInfo& info) override { team_->begin(info); }
  std::span<const NavigatorChoice> navigators() const override { return team_->navigators(); }
  TeamCommand decide(const Observation& seen) override {
    notes_->emplace_back(seen.tick, seen.*number_);
    return team_->decide(seen);
  }

 private:
  std::unique_ptr<Strategy> team_;
  int Observation::* number_;
  Notes* notes_;
};

TeamChoice noting(const std::string& name, int Observation::* number, Notes& notes) {
  return TeamChoice::own(name, [=, &notes] { return std::make_unique<Noting>(name, number, notes); });
}

}  // namespace

TEST_CASE("teams know who leads in a shoot-out, which the score does not count", "[unit]") {
  MatchConfig config = shortMatch("idle", "idle", 0.5);
  config.rules.periods.tie_break = TieBreak::kShootOut;
  config.rules.shoot_out.kick_seconds = 10.0;
  PerTeam<Notes> leads;
  config.teams = {noting("idle", &Observation::shoot_out_lead, leads[0]),
                  noting("classic", &Observation::shoot_out_lead, leads[1])};
  auto match = Match::create(config);
  REQUIRE(match);
  std::vector<int> ahead;  // of yellow, before each tick
  do ahead.push_back(match->referee().shoot_out.goals[1] - match->referee().shoot_out.goals[0]);
  while (match->step());
  CHECK(ahead.back() > 0);
  CHECK(match->referee().score == PerTeam<int>{0, 0});
  REQUIRE(leads[1].size() > 10);
  REQUIRE(leads[0].size() == leads[1].size());
  for (std::size_t i = 0; i < leads[1].size(); ++i) {
    const auto [tick, lead] = leads[1][i];
    CHECK(leads[0][i] == std::pair(tick, -lead));
    CHECK(lead == ahead.at(static_cast<std::size_t>(tick)));
  }
  CHECK(leads[1].back().second > 0);
}

TEST_CASE("teams know which part of overtime is played", "[unit]") {
  MatchConfig config = shortMatch("idle", "idle", 0.5);
  config.rules.periods.tie_break = TieBreak::kOvertime;
  config.rules.periods.overtime_parts = 2;
  config.rules.periods.overtime_seconds = 0.5;
  Notes parts;
  config.teams[0] = noting("idle", &Observation::overtime_part, parts);
  auto match = Match::create(config);
  REQUIRE(match);
  std::vector<int> periods;  // before each tick: 0 before overtime, then its part
  do {
    const RefereeState& referee = match->referee();
    periods.push_back(referee.period < kOvertimePeriod ? 0 : referee.part);
  } while (match->step());
  REQUIRE(parts.size() > 100);
  for (const auto& [tick, part] : parts) CHECK(part == periods.at(static_cast<std::size_t>(tick)));
  CHECK(parts.front().second == 0);
  CHECK(parts.back().second == 2);
}

TEST_CASE("the same configuration gives the same match, another seed another", "[unit]") {
  MatchConfig config = shortMatch();
  const std::uint64_t hash = hashOf(config);
  CHECK(hash == hashOf(config));
  config.seed = 2;
  CHECK(hash != hashOf(config));
}

TEST_CASE("who watches changes nothing, and is told in order", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 30.0);
  auto match = Match::create(config);
  REQUIRE(match);
  Diary diary;
  match->watch(diary);
  while (match->step()) {
  }
  match->finish();
  CHECK(match->referee().ended);
  CHECK_FALSE(match->step());
  CHECK(match->hash() == hashOf(config));
  CHECK(diary.calls.substr(0, 4) == "mptp");
  CHECK(diary.calls.substr(diary.calls.size() - 2) == "te");
  CHECK(diary.hashes.size() == static_cast<std::size_t>(match->tick()));
  CHECK(diary.hashes.back() == match->hash());
  CHECK(diary.starts.front() == 0);
}

TEST_CASE("a match that is ended early tells it once", "[unit]") {
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  Diary diary;
  match->watch(diary);
  for (int i = 0; i < 10; ++i) REQUIRE(match->step());
  match->finish();
  match->finish();
  CHECK(diary.calls == "mpte");
  CHECK_FALSE(match->step());
  CHECK(match->tick() == 10);
  CHECK(match->seconds() == Approx(10.0 / 60.0));
}

TEST_CASE("both teams decide on the same tick, each with its own goal at -x", "[unit]") {
  std::vector<Observation> seen;
  const Decide note = [&](const Observation& observation) {
    seen.push_back(observation);
    return allWheels({10.0, 12.0});
  };
  const TestEntry entry(note);
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  config.start = twoColumns();
  config.start->ball = {0.3, 0.5};
  auto match = Match::create(config);
  REQUIRE(match);
  for (int i = 0; i < 60; ++i) REQUIRE(match->step());
  REQUIRE(seen.size() == 120);
  for (std::size_t i = 0; i < seen.size(); i += 2) {
    const Observation &blue = seen[i], &yellow = seen[i + 1];
    REQUIRE(blue.tick == yellow.tick);
    CHECK(blue.ball.position == -yellow.ball.position);
    for (std::size_t k = 0; k < 3; ++k) {
      // The teams see mirror images, apart from the ball, which nobody has touched.
      CHECK(blue.own[k].state.pose.position == -yellow.opponents[k].state.pose.position);
      CHECK(yellow.own[k].state.pose.position == -blue.opponents[k].state.pose.position);
      CHECK(blue.own[k].present);
      CHECK(yellow.opponents[k].state.wheels.left == 0.0);
    }
    CHECK_FALSE(blue.own[3].present);
  }
  CHECK(seen.front().own[0].state.pose.position.x == Approx(-0.4));
  CHECK(seen.back().own[0].state.wheels.left > 1.0);
}

TEST_CASE("a start state is taken exactly, robots may be absent, and the score goes on", "[unit]") {
  const TestEntry entry([](const Observation&) { return allWheels({}); });
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  Placement start = twoColumns();
  start.robots[0][1].reset();
  start.robots[1][0].reset();
  start.robots[1][2].reset();
  start.ball = {0.6, 0.0};
  start.ball_velocity = {2.0, 0.0};
  start.robots[1][1]->position = {0.2, 0.4};
  config.start = start;
  config.scoreboard = {{3, 1}, 2, 1.0};
  auto match = Match::create(config);
  REQUIRE(match);
  REQUIRE(match->ids().size() == 3);
  CHECK(match->ids()[0] == RobotId{TeamId::kBlue, 0});
  CHECK(match->ids()[1] == RobotId{TeamId::kBlue, 2});
  CHECK(match->ids()[2] == RobotId{TeamId::kYellow, 1});
  CHECK(match->world().robots[1].pose.position.y == Approx(0.2).margin(1e-7));
  CHECK(match->referee().last.kind == RestartKind::kGiven);
  CHECK(match->referee().period == 2);
  Diary diary;
  match->watch(diary);
  while (match->step() && diary.starts.size() < 2) {
  }
  REQUIRE(diary.starts.size() == 2);  // the ball rolled into yellow's goal
  CHECK(match->referee().score[0] == 4);
  CHECK(match->referee().score[1] == 1);
  CHECK(match->world().tick == 0);
  CHECK(match->tick() == diary.starts[1]);
}

TEST_CASE("what cannot be played is refused with the reason", "[unit]") {
  const auto refusal = [](const std::function<void(MatchConfig&)>& spoil) {
    MatchConfig config = shortMatch();
    spoil(config);
    const auto match = Match::create(config);
    return match ? std::string("accepted") : match.error().message;
  };
  CHECK(refusal([](MatchConfig&) {}) == "accepted");
  CHECK(refusal([](MatchConfig& c) { c.teams[1].info = nullptr; }) == "the yellow team is not chosen");
  CHECK(refusal([](MatchConfig& c) { c.rules.team_size = 12; }) ==
        "team size of the rules: 12 is outside 1 ... 11");
  CHECK(refusal([](MatchConfig& c) { c.vision[0].latency_ticks = 61; }) ==
        "latency: 61 is outside 0 ... 60 ticks");
  CHECK(refusal([](MatchConfig& c) { c.vision[1].position_noise = -1.0; }) ==
        "noise: -1 is outside 0 ... 0.1 m");
  CHECK(refusal([](MatchConfig& c) { c.vision[0].heading_noise = 7.0; }) ==
        "heading noise: 7 is outside 0 ... 6.283 rad");
  CHECK(refusal([](MatchConfig& c) { c.vision[1].dropout = 1.0; }) == "dropout: 1 is outside 0 ... 0.99");
  CHECK(refusal([](MatchConfig& c) { c.decision_time = DecisionTime{-1.0, 2.0, 30}; }) ==
        "time per decision: -1 is outside 0 ... 60 s");
  CHECK(refusal([](MatchConfig& c) { c.decision_time = DecisionTime{0.02, 1e9, 30}; }) ==
        "bank of time: 1000000000 is outside 0 ... 3600 s");
  CHECK(refusal([](MatchConfig& c) { c.decision_time = DecisionTime{0.02, 2.0, -1}; }) ==
        "late decisions in a row: -1 is outside 0 ... 3600");
  CHECK(refusal([](MatchConfig& c) { c.decision_time = DecisionTime{}; }) ==
        "time per decision: there is no clock to measure it");
  CHECK(
      refusal([](MatchConfig& c) { c.field.goal_width = 0.0; }) ==
      "the rules 'vsss-3v3' cannot be played on the field 'vsss-3v3': field.goal_width = 0, it has no goals");
  CHECK(refusal([](MatchConfig& c) { c.field.length = 100.0; }).find("length") != std::string::npos);
  CHECK(refusal([](MatchConfig& c) { c.physics.substeps = 0; }).find("substeps") != std::string::npos);
  CHECK(refusal([](MatchConfig& c) { c.scoreboard.period = 4; }) ==
        "period at the start: 4 is outside 1 ... 3");
  CHECK(refusal([](MatchConfig& c) { c.start = Placement{}; }) == "start state: there is no robot");
  CHECK(refusal([](MatchConfig& c) { c.start = twoColumns(4); }) ==
        "start state: blue has a robot 3, but the rules 'vsss-3v3' have 3 robots per team, counted from 0");
  CHECK(refusal([](MatchConfig& c) {
          c.start = twoColumns();
          c.start->ball = {3.0, 0.0};
        }) == "start state: ball 0: position (3, 0) is outside the field");
}

TEST_CASE("a profile adds up what the stages took by the clock that was given", "[unit]") {
  std::int64_t now = 0;
  MatchProfile profile;
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  match->measure([&] { return now += 10; }, profile);
  while (match->step()) {
  }
  CHECK(profile.ticks == match->tick());
  CHECK(profile.step == 10 * profile.ticks);
  CHECK(profile.sense == 10 * profile.ticks);
  CHECK(profile.referee == 10 * profile.ticks);
  CHECK(profile.decide == 30 * profile.ticks);  // both teams are asked, then each decides
  CHECK(profile.navigate == 30 * profile.ticks);
  CHECK(match->hash() == hashOf(shortMatch()));
}

}  // namespace fulbito
