#include "tournament/book/book.hpp"

#include <map>
#include <set>

#include "engine/core/base/wide_hash.hpp"
#include "fulbito/detail/math.hpp"
#include "referee/geometry/placed_body.hpp"
#include "referee/restarts/restart_placement.hpp"
#include "tests/support/catch.hpp"
#include "tournament/book/draw_order.hpp"
#include "tournament/plan/plan.hpp"

namespace fulbito {
namespace {

const std::vector<StartKind> kAll{StartKind::kKickOff, StartKind::kFreeBall, StartKind::kPenalty,
                                  StartKind::kGoalKick, StartKind::kPlay};

MatchConfig matchOf(const std::string& rules = "vsss-3v3", const std::string& team = "idle") {
  const auto match = MatchConfig::standard(team, team, rules);
  REQUIRE(match);
  return *match;
}

MatchConfig started(const BookConfig& book, std::size_t index, MatchConfig match = matchOf()) {
  const auto applied = applyStart(book, index, match);
  INFO((applied ? "" : applied.error().message));
  REQUIRE(applied);
  return match;
}

WideHashValue hashOf(const Placement& placement) {
  WideHash hash;
  for (const Vec2 v : {placement.ball, placement.ball_velocity}) {
    hash.add(v.x);
    hash.add(v.y);
  }
  for (const TeamPoses& poses : placement.robots) {
    for (const auto& pose : poses) {
      if (!pose) continue;
      hash.add(pose->position.x);
      hash.add(pose->position.y);
      hash.add(pose->heading);
    }
  }
  return hash.value();
}

/// Hash of the state of all bodies at the first tick of play.
WideHashValue firstState(const MatchConfig& config) {
  auto match = Match::create(config);
  REQUIRE(match);
  REQUIRE(match->makeReady() == MatchPhase::kReady);
  return hashOf(match->placement());
}

/// Counts the referee's calls and repairs at the placement and in the first tick.
struct FirstCalls final : MatchObserver {
  std::size_t repairs = 0, calls = 0;
  std::optional<RestartKind> restart;
  void onPlayStart(const PlayStart& start) override {
    if (restart) return;
    restart = start.call.kind;
    repairs = start.events.size();
  }
  void onTick(const MatchTick& tick) override {
    if (tick.tick > 1) return;
    // At a start without a delay, the first tick announces the kick-off, which is not a call.
    for (const GameEvent& event : tick.events) calls += event.clause != "kick-off" ? 1 : 0;
  }
};

std::uint64_t hashAfter(const MatchConfig& config, double seconds) {
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->seconds() < seconds && match->step()) {
  }
  REQUIRE_FALSE(match->faults().abandoned);
  return match->hash();
}

}  // namespace

TEST_CASE("kinds of starts have names", "[unit]") {
  for (const StartKind kind : kAll) CHECK(startKindOf(nameOf(kind)) == kind);
  CHECK(kAll.size() == kStartKinds);
  CHECK_FALSE(startKindOf("corner"));
}

TEST_CASE("kinds take turns, and 10,000 entries of all shards have names of their own", "[unit]") {
  const BookConfig book{{StartKind::kPenalty, StartKind::kPlay}, 1};
  CHECK(bookEntry(book, 0).name == "penalty:0");
  CHECK(bookEntry(book, 1).name == "play:0");
  CHECK(bookEntry(book, 7).name == "play:3");
  std::set<std::string> names;
  for (const std::size_t shard : {0U, 1U, 2U}) {
    for (std::size_t i = shard; i < 10000; i += 3) names.insert(bookEntry({kAll, 1}, i).name);
  }
  CHECK(names.size() == 10000);
}

TEST_CASE("a book without kinds, or with one twice, is refused", "[unit]") {
  CHECK(validate(BookConfig{}));
  CHECK_FALSE(validate(BookConfig{{}, 1}));
  const auto twice = validate(BookConfig{{StartKind::kPlay, StartKind::kPenalty, StartKind::kPlay}, 1});
  REQUIRE_FALSE(twice);
  CHECK(twice.error().message == "the book lists 'play' twice");
  MatchConfig match = matchOf();
  CHECK_FALSE(applyStart({{}, 1}, 0, match));
}

TEST_CASE("a start state goes with kick-offs only", "[unit]") {
  MatchConfig match = matchOf();
  match.start = Placement{};
  CHECK(applyStart(BookConfig{}, 3, match));
  for (const std::size_t index : {0U, 1U}) {
    CHECK_FALSE(applyStart({{StartKind::kKickOff, StartKind::kPlay}, 1}, index, match));
  }
}

TEST_CASE("a kick-off changes nothing", "[unit]") {
  const MatchConfig match = started({}, 5);
  CHECK_FALSE(match.start);
  CHECK_FALSE(match.opening);
}

TEST_CASE("a start is a function of its kind, the seed and its turn alone", "[unit]") {
  const BookConfig all{kAll, 7};
  for (std::size_t index = 1; index < 25; ++index) {
    const StartKind kind = bookEntry(all, index).kind;
    INFO(bookEntry(all, index).name);
    if (kind == StartKind::kKickOff) continue;
    const MatchConfig a = started(all, index), b = started({{kind}, 7}, index / kStartKinds);
    CHECK(a.start.has_value() == (kind == StartKind::kPlay));
    CHECK(a.opening.has_value() == (kind != StartKind::kPlay));
    if (a.start) CHECK(hashOf(*a.start) == hashOf(*b.start));
    if (!a.opening) continue;
    CHECK(a.opening->team == b.opening->team);
    CHECK(hashOf(a.opening->defaults) == hashOf(b.opening->defaults));
  }
}

TEST_CASE("teams, vision, times and the match's seed do not change a start", "[unit]") {
  for (const StartKind kind : {StartKind::kFreeBall, StartKind::kPlay}) {
    MatchConfig other = matchOf("vsss-3v3", "chaser");
    other.seed = 99;
    other.vision[0].latency_ticks = 4;
    other.rules.half_seconds = 5;
    const MatchConfig a = started({{kind}, 1}, 2), b = started({{kind}, 1}, 2, other);
    if (a.start) CHECK(hashOf(*a.start) == hashOf(*b.start));
    if (a.opening) CHECK(hashOf(a.opening->defaults) == hashOf(b.opening->defaults));
  }
}

TEST_CASE("marks and sides are balanced, in an order that the seed draws", "[unit]") {
  std::set<std::vector<std::size_t>> orders;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<std::size_t> order;
    for (std::uint64_t turn = 0; turn < 8; ++turn) {
      order.push_back(caseOf({StartKind::kFreeBall, seed, turn}, 4));
    }
    for (const std::size_t block : {0U, 4U}) {
      CHECK(std::set<std::size_t>(order.begin() + static_cast<std::ptrdiff_t>(block),
                                  order.begin() + static_cast<std::ptrdiff_t>(block) + 4)
                .size() == 4);
    }
    orders.insert(order);
  }
  CHECK(orders.size() > 15);

  std::map<std::pair<double, double>, int> marks;
  for (std::size_t i = 0; i < 40; ++i) {
    const RestartCall call = *started({{StartKind::kFreeBall}, 3}, i).opening;
    CHECK(call.kind == RestartKind::kFreeBall);
    ++marks[{call.ball.x, call.ball.y}];
    // Blue attacks the right half.
    CHECK(call.team == (call.ball.x > 0.0 ? TeamId::kBlue : TeamId::kYellow));
  }
  CHECK(marks.size() == 4);
  for (const auto& [mark, count] : marks) CHECK(count == 10);

  for (const StartKind kind : {StartKind::kPenalty, StartKind::kGoalKick}) {
    PerTeam<int> takes{};
    for (std::size_t i = 0; i < 40; ++i) ++takes[indexOf(started({{kind}, 3}, i).opening->team)];
    CHECK(takes == PerTeam<int>{20, 20});
  }
}

TEST_CASE("with the seed of its pair, no start of a tournament repeats another", "[unit]") {
  const BookConfig book{
      {StartKind::kKickOff, StartKind::kFreeBall, StartKind::kPenalty, StartKind::kGoalKick}, 1};
  std::set<WideHashValue> states;
  constexpr std::size_t kStarts = 10000;
  for (std::size_t i = 0; i < kStarts; ++i) {
    MatchConfig match = started(book, i);
    match.seed = seedOfStart(1, i);
    states.insert(firstState(match));
  }
  CHECK(states.size() == kStarts);
}

TEST_CASE("every start is legal: the referee repairs nothing and calls nothing in the first tick", "[unit]") {
  constexpr double kSeconds = 2.0;
  for (const std::string& rules : rulesPresetNames()) {
    for (const StartKind kind : kAll) {
      for (std::size_t i = 0; i < 8; ++i) {
        MatchConfig config = started({{kind}, 11}, i, matchOf(rules, i % 2 == 0 ? "idle" : "chaser"));
        config.seed = seedOfStart(3, i);
        INFO(rules << " " << bookEntry({{kind}, 11}, i).name);
        auto match = Match::create(config);
        REQUIRE(match);
        FirstCalls first;
        match->watch(first);
        while (match->seconds() < kSeconds && match->step()) {
        }
        CHECK(match->seconds() >= kSeconds);
        CHECK(first.repairs == 0);
        CHECK(first.calls == 0);
        CHECK_FALSE(match->faults().abandoned);
        if (config.opening) CHECK(first.restart == config.opening->kind);
        if (config.opening)
          CHECK(legalPlacement(refereeSetup(config), {}, *config.opening, config.opening->defaults));
      }
    }
  }
}

TEST_CASE("a team against itself: both matches of a pair are equal from every kind of start", "[unit]") {
  for (const char* team : {"chaser", "classic"}) {
    const MatchConfig base = matchOf("vsss-3v3", team);
    for (const StartKind kind : kAll) {
      for (std::size_t i = 0; i < 2; ++i) {
        INFO(team << " " << nameOf(kind) << " " << i);
        MatchConfig first = started({{kind}, 5}, i, base), second = first;
        second.teams = {first.teams[1], first.teams[0]};
        std::swap(second.vision[0], second.vision[1]);
        CHECK(hashAfter(first, 4.0) == hashAfter(second, 4.0));
      }
    }
  }
}

TEST_CASE("both roles of a start fall to each team of a pair", "[unit]") {
  // The seat of the taker stays, while the teams exchange theirs.
  MatchConfig first = started({{StartKind::kPenalty}, 1}, 0, matchOf("vsss-3v3", "chaser"));
  first.teams[1] = *parseTeam("idle");
  MatchConfig second = first;
  std::swap(second.teams[0], second.teams[1]);
  for (MatchConfig* leg : {&first, &second}) {
    auto match = Match::create(*leg);
    REQUIRE(match);
    match->makeReady();
    CHECK(match->referee().last.team == first.opening->team);
  }
}

TEST_CASE("all kinds work with 1 to 11 robots per team", "[unit]") {
  for (const char* rules : {"vsss-3v3", "vsss-5v5"}) {
    for (int size = 1; size <= kMaxTeamSize; ++size) {
      for (const StartKind kind : kAll) {
        MatchConfig match = matchOf(rules);
        match.rules.team_size = size;
        INFO(rules << " " << size << " " << nameOf(kind));
        auto made = Match::create(started({{kind}, 2}, 1, match));
        REQUIRE(made);
        FirstCalls first;
        made->watch(first);
        REQUIRE(made->step());
        CHECK(made->ids().size() == 2 * static_cast<std::size_t>(size));
        if (kind != StartKind::kKickOff) CHECK(first.repairs == 0);
      }
    }
  }
}

TEST_CASE("a field too small for all robots at a restart is refused", "[unit]") {
  MatchConfig match = matchOf();
  match.rules.team_size = kMaxTeamSize;
  match.robot.robot.length = match.robot.robot.width = 0.3;
  const auto applied = applyStart({{StartKind::kPenalty}, 1}, 0, match);
  REQUIRE_FALSE(applied);
  CHECK(applied.error().message ==
        "start 'penalty': the field 'vsss-3v3' has no room for 11 robots per team at this restart");
}

TEST_CASE("a field without marks, and bad rules, are refused", "[unit]") {
  const auto refusal = [](StartKind kind, auto change) {
    MatchConfig match = matchOf();
    change(match);
    const auto applied = applyStart({{kind}, 1}, 0, match);
    REQUIRE_FALSE(applied);
    CHECK_FALSE(match.opening);
    CHECK_FALSE(match.start);
    return applied.error().message;
  };
  CHECK(refusal(StartKind::kFreeBall, [](auto& m) { m.field.free_ball_mark = {}; }) ==
        "start 'free-ball': the field 'vsss-3v3' has no mark for the ball");
  CHECK(refusal(StartKind::kPenalty, [](auto& m) { m.field.penalty_mark = 0.0; }) ==
        "start 'penalty': the field 'vsss-3v3' has no mark for the ball");
  CHECK(refusal(StartKind::kPlay, [](auto& m) { m.rules.team_size = 12; }) != "");
  CHECK(refusal(StartKind::kGoalKick, [](auto& m) { m.field.goal_width = 0.0; }) != "");
}

}  // namespace fulbito
