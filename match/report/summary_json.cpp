#include "engine/core/base/text_controls.hpp"
#include "fulbito/statistics.hpp"
#include "match/report/match_json.hpp"

namespace fulbito {
namespace {

Json teamsJson(const PerTeam<TeamChoice>& teams, const char* first, const char* second) {
  return {{first, teams[0].text}, {second, teams[1].text}};
}

Json goalJson(const GoalRecord& goal) {
  return {{"time_s", goal.seconds},
          {"period", goal.period},
          {"play_s", goal.play_time},
          {"team", nameOf(goal.team)},
          {"scorer_team", goal.scorer ? Json(nameOf(goal.scorer->team)) : Json(nullptr)},
          {"scorer", goal.scorer ? Json(goal.scorer->number) : Json(nullptr)},
          {"own_goal", goal.own_goal},
          {"score", {goal.score[0], goal.score[1]}}};
}

Json fullScoreJson(const MatchReport& report) {
  const RefereeState& referee = report.referee;
  Json score = scoreJson(referee.score);
  score["winner"] = referee.winner ? Json(nameOf(*referee.winner)) : Json(nullptr);
  score["complete"] = report.complete;
  if (referee.period == kShootOutPeriod) score["shoot_out"] = scoreJson(referee.shoot_out.goals);
  score["goals"] = Json::array();
  for (const GoalRecord& goal : report.statistics.goals) score["goals"].push_back(goalJson(goal));
  return score;
}

Json robotJson(const RobotStatistics& robot, std::size_t number, double dt) {
  return {{"robot", number},
          {"on_field_s", static_cast<double>(robot.ticks) * dt},
          {"distance_m", robot.distance},
          {"touches", robot.touches},
          {"shots", robot.shots},
          {"goals", robot.goals}};
}

// Origin and containment of teams that are files or programs.
Json originJson(const MatchConfig& config) {
  Json json = Json::object();
  for (const TeamId team : kTeams) {
    for (const Setting& entry : config.teams[indexOf(team)].origin)
      json[nameOf(team)][entry.name] = entry.value;
  }
  return json;
}

Json faultsJson(const TeamFaults& faults) {
  return {{"rejected", faults.rejected()},
          {"not_finite", faults.not_finite},
          {"no_navigator", faults.no_navigator},
          {"late", faults.late},
          {"stale", faults.stale},
          {"failures", faults.failures},
          {"failure", faults.failure},
          {"forfeited", faults.forfeited},
          {"saturated", faults.saturated}};
}

Json playJson(const MatchStatistics& s, TeamId team) {
  const TeamPlay& play = s.teams[indexOf(team)].play;
  return {{"slow_share", play.slow()},
          {"field_slow_share", play.fieldSlow()},
          {"uncovered_share", s.uncovered(team)},
          {"field_uncovered_share", s.fieldUncovered(team)},
          {"keeper_away_share", play.keeperAway()},
          {"locks", play.locks},
          {"long_contacts", play.long_contacts},
          {"longest_contact_s", static_cast<double>(play.longest_contact) * s.dt}};
}

Json teamJson(const MatchReport& report, TeamId team) {
  const MatchStatistics& s = report.statistics;
  const TeamStatistics& t = s.teams[indexOf(team)];
  Json json = {{"possession_share", s.possession(team)},
               {"own_third_share", s.third(team, 0)},
               {"middle_third_share", s.third(team, 1)},
               {"opponents_third_share", s.third(team, 2)},
               {"mean_ball_x_m", s.meanBallX(team)},
               {"shots", t.shots},
               {"shots_on_goal", t.shots_on_goal},
               {"own_goals", t.own_goals},
               {"goals_after_foul", t.goals_after_foul},
               {"touches", t.touches()},
               {"distance_m", t.distance()},
               {"wall_contacts", t.wall_contacts},
               {"mate_contacts", t.mate_contacts},
               {"commands", faultsJson(report.faults.teams[indexOf(team)])},
               {"robots", Json::array()}};
  json.update(playJson(s, team));
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.team_size); ++i) {
    json["robots"].push_back(robotJson(t.robots[i], i, s.dt));
  }
  return json;
}

Json statsJson(const MatchReport& report) {
  const MatchStatistics& s = report.statistics;
  Json restarts = Json::object(), calls = Json::object();
  for (std::size_t kind = 0; kind < s.restarts.size(); ++kind) {
    restarts[nameOf(static_cast<RestartKind>(kind))] = scoreJson(s.restarts[kind]);
  }
  for (const CallCount& call : s.calls) {
    Json count = scoreJson(call.against);
    count["neither"] = call.neither;
    count["paid"] = scoreJson(call.paid);
    calls[std::string(call.clause)] = std::move(count);
  }
  return {{"play_s", static_cast<double>(s.play_ticks) * s.dt},
          {"waiting_s", static_cast<double>(s.waiting_ticks) * s.dt},
          {"blue", teamJson(report, TeamId::kBlue)},
          {"yellow", teamJson(report, TeamId::kYellow)},
          {"opponent_contacts", s.opponent_contacts},
          {"wall_share", s.atWall()},
          {"corner_share", s.inCorner()},
          {"restarts", std::move(restarts)},
          {"calls", std::move(calls)}};
}

Json profileJson(const MatchProfile& p) {
  return {{"ticks", p.ticks},          {"sense_ns", p.sense},
          {"strategies_ns", p.decide}, {"navigation_ns", p.navigate},
          {"physics_ns", p.step},      {"referee_ns", p.referee},
          {"restarts_ns", p.restart},  {"recording_ns", p.record}};
}

double timesRealTime(double simulated, double wall) { return wall > 0.0 ? simulated / wall : 0.0; }

}  // namespace

std::string matchJson(const MatchReport& report) {
  Json json = {{"schema_version", kMatchSchemaVersion},
               {"teams", teamsJson(report.config.teams, "blue", "yellow")},
               {"score", fullScoreJson(report)},
               {"edited", report.edits > 0},
               {"edits", report.edits},
               {"events", Json::array()},
               {"events_left_out", report.events_left_out},
               {"stats", statsJson(report)},
               {"seed", report.config.seed},
               {"config", matchConfigJson(report.config)},
               {"build", buildJson()},
               {"final_hash", hashText(report.final_hash)},
               {"simulated_s", report.simulated},
               {"x_realtime", timesRealTime(report.simulated, report.wall)},
               {"wall_s", report.wall}};
  for (const LoggedEvent& event : report.events) {
    json["events"].push_back(eventJson(event, report.statistics.dt));
  }
  if (Json origin = originJson(report.config); !origin.empty()) json["origin"] = std::move(origin);
  if (report.faults.abandoned) json["abandoned"] = report.faults.abandoned->message;
  if (report.profile) json["compute_profile"] = profileJson(*report.profile);
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace fulbito
