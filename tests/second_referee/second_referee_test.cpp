#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/second_referee/judge_matches.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito::second {
namespace {

/// The share of a body in an area, by counting points.
double countedShare(const Marking& area, const Corners& c, int n) {
  int in = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Vec2 p = c[0] + (c[1] - c[0]) * ((i + 0.5) / n) + (c[3] - c[0]) * ((k + 0.5) / n);
      in += isIn(area, p) ? 1 : 0;
    }
  }
  return static_cast<double>(in) / (n * n);
}

/// A rule that a second referee has wrong.
struct Lie {
  const char* what;
  void (*tell)(Rules&);
};

const std::array<Lie, 8> kLies = {
    Lie{"goals as soon as the centre is over", [](Rules& r) { r.goal.ball = BallPart::kCentre; }},
    Lie{"penalties half a second sooner", [](Rules& r) { r.areas.defenders_wait = 0.5; }},
    Lie{"attackers by their centre", [](Rules& r) { r.areas.attackers_part = BodyPart::kCentre; }},
    Lie{"who touched a tick longer ago takes part", [](Rules& r) { r.areas.part_seconds = 0.6; }},
    Lie{"charges of a tick less", [](Rules& r) { r.keeper.charge_seconds = 11.0 / 60.0; }},
    Lie{"free balls a tick later", [](Rules& r) { r.stuck.seconds = 601.0 / 60.0; }},
    Lie{"no 8.3", [](Rules& r) { r.areas.defenders = false; }},
    Lie{"kicks that go on in the keeper's hold", [](Rules& r) { r.shoot_out.held_seconds = 0.0; }}};

/// Brings the ball into the keeper's hold at each kick of a shoot-out. The kicker pushes the ball straight at
/// the keeper and stops. The keeper follows the ball with its face, so the ball never rests. Else all stand
/// still.
TeamCommand heldKicks(const Observation& seen) {
  TeamCommand command = test::allWheels({});
  if (!seen.playing || seen.period != 4) return command;
  const bool kicks = seen.restart_is_ours;
  for (std::size_t i = 0; i < seen.own.size(); ++i) {
    const double gap = distance(seen.own[i].state.pose.position, seen.ball.position);
    const bool drives = kicks ? seen.since_restart < 0.5 && seen.ball.velocity.x < 0.3 : gap < 0.1;
    const double speed = kicks ? 30.0 : 4.0;  // rad/s
    if (drives) command.robots[i] = RobotCommand::byWheels({speed, speed});
  }
  return command;
}

/// A second referee that goes by other rules than the match.
struct Misled final : MatchObserver {
  void onMatchStart(const MatchConfig& config) override {
    MatchConfig other = config;
    lie->tell(other.rules);
    second.onMatchStart(other);
  }
  void onPlayStart(const PlayStart& start) override { second.onPlayStart(start); }
  void onTick(const MatchTick& tick) override { second.onTick(tick); }
  const Lie* lie = nullptr;
  SecondReferee second;
};

}  // namespace

TEST_CASE("the second referee's areas: by counting points", "[unit]") {
  Rng rng(3, test::kTestStream);
  for (const bool arc : {true, false}) {
    const Marking area = goalArea(FieldGeometry{}, arc);
    for (int i = 0; i < 400; ++i) {
      const Pose2 pose{{0.26 * rng.uniform(), 0.9 * (rng.uniform() - 0.5)}, 6.3 * rng.uniform() - 3.1};
      const Corners body = cornersOf(pose, 0.075, 0.075);
      const double share = shareIn(area, body), counted = countedShare(area, body, 60);
      CAPTURE(pose.position.x, pose.position.y, pose.heading);
      REQUIRE(std::abs(share - counted) < 0.02);
      if (counted > 0.0) REQUIRE(anyPartIn(area, body));
      if (!anyPartIn(area, body)) REQUIRE(share < 1e-9);
    }
  }
}

TEST_CASE("the second referee's areas: known shares", "[unit]") {
  const Marking area = goalArea(FieldGeometry{}, true);
  const auto share = [&](double u, double v, double heading) {
    return shareIn(area, cornersOf({{u, v}, heading}, 0.08, 0.08));
  };
  CHECK(share(0.05, 0.0, 0.7) == Approx(1.0));
  CHECK(share(0.15, 0.25, 0.0) == Approx(0.5));
  CHECK(share(0.15, 0.25, math::kPi / 4) == Approx(0.5));
  CHECK(share(0.07, 0.35, 0.3) == Approx(0.5));
  // The segment beyond the front line: r = 0.125, chord 0.2, height 0.05; a body that covers the arc's
  // middle.
  const double r = 0.125, half = 0.04;
  const double strip = half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r) - 2 * half * 0.075;
  CHECK(share(0.19, 0.0, 0.0) == Approx(strip / 0.0064));
  CHECK(anyPartIn(area, cornersOf({{0.2399, 0.0}, 0.0}, 0.08, 0.08)));
  CHECK_FALSE(anyPartIn(area, cornersOf({{0.2401, 0.0}, 0.0}, 0.08, 0.08)));
}

TEST_CASE("both referees agree on every call of short matches", "[unit]") {
  Verdict verdict;
  // Of each profile a few pairings; the long test plays them all.
  for (const int index : {5, 9, 12, 22, 27, 42, 44, 57, 68, 72, 78, 84})
    judgeMatch(index, 25.0, 1000, verdict);
  CHECK(verdict.calls() > 60);
  for (const std::string& line : verdict.disagreements) FAIL_CHECK(line);
}

TEST_CASE("the second referee sees calls that are missing, wrong, early and late", "[unit]") {
  std::array<Misled, kLies.size()> misled;
  for (std::size_t i = 0; i < kLies.size(); ++i) misled[i].lie = &kLies[i];
  std::array<int, kLies.size()> seen{};
  const auto look = [&](Match match) {
    for (Misled& one : misled) {
      one.second = {};
      match.watch(one);
    }
    while (match.step()) {
    }
    for (std::size_t i = 0; i < kLies.size(); ++i) {
      seen[i] += static_cast<int>(misled[i].second.disagreements().size());
    }
  };
  const test::TestEntry holding(heldKicks);
  look(matchOf({holding.choice(), holding.choice()}, judgedRules().back(), 1.0, 1));
  // The shoot-out shows this one lie and no other.
  CHECK(seen.back() > 0);
  CHECK(std::accumulate(seen.begin(), seen.end() - 1, 0) == 0);
  for (std::uint64_t seed = 7; seed <= 12 && std::count(seen.begin(), seen.end(), 0) > 0; ++seed) {
    look(matchOf("chaser", seed % 2 == 0 ? "classic" : "chaser", judgedRules().front(), 120.0, seed));
  }
  for (std::size_t i = 0; i < kLies.size(); ++i) {
    INFO(kLies[i].what);
    CHECK(seen[i] > 0);
  }
}

}  // namespace fulbito::second
