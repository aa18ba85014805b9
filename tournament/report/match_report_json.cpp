#include "match/report/match_json.hpp"
#include "tournament/report/json_parts.hpp"
#include "tournament/report/match_report.hpp"

namespace fulbito {
namespace {

Json legJson(const TournamentState& state, std::size_t fixture, std::size_t leg) {
  const PairResult& pair = *state.results[fixture];
  const MatchResult& played = pair.legs[leg];
  return {{"pair", fixture},
          {"leg", leg + 1},
          {"seed", pair.seed},
          {"blue", leg == 0 ? "a" : "b"},
          {"goals_a", played.score[leg]},
          {"goals_b", played.score[1 - leg]},
          {"goals_after_foul_a", played.goals_after_foul[leg]},
          {"goals_after_foul_b", played.goals_after_foul[1 - leg]},
          {"simulated_s", static_cast<double>(played.ticks) * state.plan.match.physics.controlPeriod()},
          {"rejected_a", played.faults.teams[leg].rejected()},
          {"rejected_b", played.faults.teams[1 - leg].rejected()},
          {"abandoned", played.faults.abandoned.has_value()},
          {"final_hash", hashText(played.hash)}};
}

/// The matches as JSON text, written one by one: a single JSON value would take hundreds of megabytes.
std::string legsText(const TournamentState& state, const MatchFigures& figures) {
  std::string text;
  for (const std::size_t fixture : figures.fixtures) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      text += (text.empty() ? "\n    " : ",\n    ") + indented(legJson(state, fixture, leg), 4);
    }
  }
  return text.empty() ? text : text + "\n  ";
}

Json betterJson(const MatchFigures& figures) {
  const auto better = betterTeam(figures);
  return better ? Json(*better == 0 ? "a" : "b") : Json(nullptr);
}

std::string nameOfTeam(const TournamentState& state, std::size_t entrant) {
  return state.plan.entrants[entrant].name;
}

void addSums(Json& json, const MeetingSummary& sums) {
  json["wins"] = sums.won;
  json["draws"] = sums.drawn;
  json["losses"] = sums.lost;
}

void addConfig(Json& json, const TournamentState& state) {
  json["unplayed"] = unplayedJson(state.unplayed);
  json["seed"] = state.plan.seed;
  json["config"] = matchConfigJson(state.plan.match);
  json["build"] = buildJson();
}

Json meansJson(const TeamMeans& means) {
  return {{"goals_per_match", means.goals},
          {"goals_per_10min", means.goal_rate},
          {"shots_per_match", means.shots},
          {"shots_on_goal_per_match", means.shots_on_goal},
          {"own_goals_per_match", means.own_goals},
          {"own_third_share", means.own_third},
          {"slow_share", means.slow},
          {"field_slow_share", means.field_slow},
          {"uncovered_share", means.uncovered},
          {"field_uncovered_share", means.field_uncovered},
          {"keeper_away_share", means.keeper_away},
          {"locks_per_match", means.locks},
          {"long_contacts_per_match", means.long_contacts},
          {"longest_contact_s", means.longest_contact}};
}

Json playJson(const PlayMeans& play) {
  return {{"play_s", play.play},
          {"wall_share", play.at_wall},
          {"corner_share", play.in_corner},
          {"a", meansJson(play.teams[0])},
          {"b", meansJson(play.teams[1])}};
}

Json seriesJson(const TournamentState& state, const MatchFigures& figures) {
  Json json{{"schema_version", kMatchSchemaVersion},
            {"teams", {{"a", nameOfTeam(state, 0)}, {"b", nameOfTeam(state, 1)}}},
            {"pairs", figures.fixtures.size()},
            {"complete", state.finished()}};
  addSums(json, figures.sums);
  const Interval &share = figures.sums.points_share, &goals = figures.goal_difference;
  json["points_share"] = share.value;
  json["points_share_low"] = share.low;
  json["points_share_high"] = share.high;
  json["goal_difference"] = numberOrNull(goals.value);
  json["goal_difference_low"] = numberOrNull(goals.low);
  json["goal_difference_high"] = numberOrNull(goals.high);
  json["better"] = betterJson(figures);
  json["goals_for"] = figures.sums.goals_for;
  json["goals_against"] = figures.sums.goals_against;
  json["goals_after_foul_for"] = figures.goals_after_foul_for;
  json["goals_after_foul_against"] = figures.goals_after_foul_against;
  json["play"] = playJson(figures.play);
  json["matches"] = Json::array();
  addConfig(json, state);
  json["simulated_s"] = figures.simulated;
  return json;
}

Json testJson(const TournamentState& state, const MatchFigures& figures) {
  Json json{{"schema_version", kMatchSchemaVersion},
            {"new", nameOfTeam(state, 0)},
            {"base", nameOfTeam(state, 1)},
            {"verdict", nameOf(state.sprt->verdict())},
            {"complete", state.finished()}};
  json.update(sprtJson(*state.sprt));
  json["pairs"] = state.sprt->counts().pairs();
  json["most_pairs"] = state.plan.pairs;
  json["counts"] = state.sprt->counts().counts;
  addSums(json, figures.sums);
  json["goals_for"] = figures.sums.goals_for;
  json["goals_against"] = figures.sums.goals_against;
  json["elo"] = intervalJson(figures.sums.elo.elo);
  json["normalized_elo"] = intervalJson(figures.sums.elo.normalized_elo);
  json["superiority"] = figures.sums.elo.superiority;
  addConfig(json, state);
  return json;
}

}  // namespace

std::string matchReportJson(const TournamentState& state) {
  const MatchFigures figures = matchFigures(state);
  Json json = state.sprt ? testJson(state, figures) : seriesJson(state, figures);
  std::string text = indented(json, 0) + '\n';
  if (state.sprt) return text;
  // Only the key can match this text, because JSON strings escape line ends.
  constexpr std::string_view kMark = "\n  \"matches\": [";
  return text.insert(text.find(kMark) + kMark.size(), legsText(state, figures));
}

}  // namespace fulbito
