#include "python/environments/match/truth.hpp"

#include "strategies/interface/team_frame.hpp"

namespace fulbito {

Observation truthFor(const Match& match, TeamId team) {
  const RefereeState& referee = match.referee();
  const Side side = referee.sideOf(team);
  Observation seen;
  seen.team_size = match.config().rules.team_size;
  seen.ball = inTeamFrame(side, match.world().balls.front());
  const auto ids = match.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    auto& robot = (ids[i].team == team ? seen.own : seen.opponents)[ids[i].number];
    robot = {true, inTeamFrame(side, match.world().robots[i])};
  }
  seen.playing = referee.playing;
  seen.remaining =
      static_cast<double>(referee.period_ticks - referee.play_ticks) * match.config().physics.controlPeriod();
  seen.own_score = referee.score[indexOf(team)];
  seen.opponent_score = referee.score[indexOf(other(team))];
  return seen;
}

}  // namespace fulbito
