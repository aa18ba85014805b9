#include "referee/match_referee.hpp"

#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito {
namespace {

constexpr double kKickOffPlaces[3] = {0.675, 0.2, 0.4};  // [m] keeper, attacker, supporter

}  // namespace

MatchReferee::MatchReferee(const RefereeSetup& setup) : setup_(setup) {
  state_.blue_side = setup.blue_side;
  state_.score = setup.scoreboard.score;
  state_.period = setup.scoreboard.period;
  state_.play_ticks = static_cast<Tick>(std::floor(setup.scoreboard.play_seconds / setup.dt + 0.5));
}

RestartCall MatchReferee::open() { return kickOff(TeamId::kBlue); }

RestartCall MatchReferee::kickOff(TeamId team) const {
  RestartCall call;
  call.kind = RestartKind::kKickOff;
  call.team = team;
  for (const TeamId t : kTeams) {
    const Side side = t == TeamId::kBlue ? state_.blue_side : opposite(state_.blue_side);
    const double sign = side == Side::kLeft ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      call.defaults.robots[indexOf(t)][i] =
          Pose2{{sign * kKickOffPlaces[i], 0.0}, side == Side::kLeft ? 0.0 : -math::kPi};
    }
  }
  return call;
}

std::optional<RestartCall> MatchReferee::observe(const MatchView& view, std::vector<GameEvent>& events) {
  ++state_.play_ticks;
  const double time = static_cast<double>(state_.play_ticks) * setup_.dt;
  const double beyond = std::abs(view.ball.position.x) - setup_.field.length / 2;
  GameEvent event;
  event.tick = view.tick;
  event.play_time = time;
  event.period = static_cast<std::uint8_t>(state_.period);
  event.place = view.ball.position;
  if (beyond > setup_.ball.radius) {
    const Side goal = view.ball.position.x < 0.0 ? Side::kLeft : Side::kRight;
    const TeamId conceded = goal == state_.blue_side ? TeamId::kBlue : TeamId::kYellow;
    ++state_.score[indexOf(other(conceded))];
    event.clause = "goal";
    event.law = "7.1";
    event.team = other(conceded);
    events.push_back(event);
    return kickOff(conceded);
  }
  if (time < setup_.rules.half_seconds) return std::nullopt;
  event.clause = "half";
  event.law = "5";
  events.push_back(event);
  if (state_.period == 2) {
    state_.ended = true;
    return std::nullopt;
  }
  state_.period = 2;
  state_.play_ticks = 0;
  return kickOff(TeamId::kYellow);
}

void MatchReferee::restarted(const RestartCall& call, const Placement&, Tick tick) {
  state_.playing = true;
  state_.last = call;
  state_.play_began = tick;
}

}  // namespace fulbito
