#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Whether the team `taker` scores from a penalty in 2.5 s, with robots of `firasim` and libero's keeper.
bool scores(const char* taker, TeamId seat) {
  const Match match = test::playedFromRestart(RestartKind::kPenalty, taker, "libero", seat, "firasim", 2.5);
  return match.referee().score[static_cast<std::size_t>(seat)] > 0;
}

}  // namespace

TEST_CASE("libero's penalty goes in past a keeper that stays in its goal", "[unit]") {
  for (const TeamId seat : {TeamId::kBlue, TeamId::kYellow}) {
    CHECK(scores("libero", seat));
    CHECK_FALSE(scores("libero:without=rush", seat));
  }
}

TEST_CASE("libero runs straight at a penalty's ball that lies if that is a shot at a corner", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const Vec2 ball{0.375, 0.0};
  // How fast [rad/s] the taker turns that comes from `y` [m], while their keeper stays.
  const auto turns = [&](double y, Vec2 rolling, double since_restart = 0.3) {
    Observation seen;
    seen.team_size = 3;
    seen.playing = true;
    seen.restart = RestartKind::kPenalty;
    seen.restart_is_ours = true;
    seen.since_restart = since_restart;
    seen.ball = {ball, rolling, rolling};
    const Vec2 way{0.4, -y};
    seen.own[0] = test::standingAt({{-0.71, 0.0}, math::kPi / 2});
    seen.own[1] = test::standingAt({ball - way, math::angleOf(way)});
    seen.opponents[0] = test::standingAt({{0.71, 0.0}, math::kPi / 2});
    const auto team = test::liberoIn(info);
    return std::abs(test::twistOf(info, team->decide(seen).robots[1]).angular);
  };
  for (const double side : {1.0, -1.0}) {
    CHECK(turns(side * 0.17, {}) < 0.1);
    CHECK(turns(side * 0.05, {}) > 0.1);
    CHECK(turns(side * 0.05, {}, 0.0) > 0.1);  // at once, since its way is short
    CHECK(turns(side * 0.17, {0.5, side * 0.3}) > 0.1);
  }
}

}  // namespace fulbito
