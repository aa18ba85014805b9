#include "tournament/report/counted_results.hpp"
#include "tournament/report/json_parts.hpp"
#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {
namespace {

/// Version of the object. It increases when a key changes its meaning or disappears.
constexpr int kTournamentSchemaVersion = 1;

Json indexOrNull(const std::optional<std::size_t>& entrant) {
  return entrant ? Json(*entrant) : Json(nullptr);
}

Json meetingJson(const MeetingSummary& meeting) {
  return {{"pairs", meeting.pairs},
          {"won", meeting.won},
          {"drawn", meeting.drawn},
          {"lost", meeting.lost},
          {"goals_for", meeting.goals_for},
          {"goals_against", meeting.goals_against},
          {"points_share", intervalJson(meeting.points_share)},
          {"elo", intervalJson(meeting.elo.elo)},
          {"normalized_elo", intervalJson(meeting.elo.normalized_elo)},
          {"superiority", meeting.elo.superiority}};
}

Json configJson(const TournamentPlan& plan) {
  Json json = matchConfigJson(plan.match);
  json["pairs"] = plan.pairs;
  json["rounds"] = plan.rounds;
  json["groups"] = plan.groups;
  json["book"]["seed"] = plan.book.seed;
  for (const StartKind kind : plan.book.kinds) json["book"]["kinds"].push_back(nameOf(kind));
  return json;
}

Json faultsJson(const FaultSummary& faults) {
  Json json;
  for (std::size_t i = 0; i < kMatchOutcomes; ++i) {
    json[std::string(nameOf(static_cast<MatchOutcome>(i)))] = faults.outcomes[i];
  }
  json["last_failure"] = faults.last_failure;
  return json;
}

Json courseJson(const std::vector<double>& course) {
  Json json = Json::array();
  for (const double elo : course) json.push_back(numberOrNull(elo));
  return json;
}

Json startsJson(const TournamentState& state, const std::vector<MeetingSummary>& starts) {
  Json json = Json::object();
  for (const StartKind kind : state.plan.book.kinds) {
    json[std::string(nameOf(kind))] = meetingJson(starts[static_cast<std::size_t>(kind)]);
  }
  return json;
}

Json entrantJson(const TournamentState& state, const TournamentTable& table, std::size_t entrant) {
  const bool beyond = std::abs(table.ratings.elo[entrant].value) > kMostShownElo;
  return {{"elo_beyond_scale", beyond},
          {"name", state.plan.entrants[entrant].name},
          {"team", state.plan.entrants[entrant].team.text},
          {"elo", intervalJson(table.ratings.elo[entrant])},
          {"compares_with", table.ratings.component[entrant]},
          {"total", meetingJson(table.totals[entrant])},
          {"starts", startsJson(state, table.starts[entrant])},
          {"faults", faultsJson(table.faults[entrant])},
          {"course", courseJson(table.course[entrant])}};
}

Json standingJson(const Standing& s) {
  return {{"rank", s.rank},
          {"entrant", s.entrant},
          {"group", s.group},
          {"matches", s.matches},
          {"won", s.won},
          {"drawn", s.drawn},
          {"lost", s.lost},
          {"goals_for", s.goals_for},
          {"goals_against", s.goals_against},
          {"points", s.points},
          {"pair_points", s.pair_points},
          {"byes", s.byes},
          {"decided_by", s.decided_by}};
}

Json tieJson(const KnockOutTie& tie) {
  return {{"round", tie.round},
          {"third_place", tie.third_place},
          {"a", indexOrNull(tie.a)},
          {"b", indexOrNull(tie.b)},
          {"winner", indexOrNull(tie.winner)},
          {"points_a", tie.points_a},
          {"points_b", tie.points_b},
          {"goals_a", tie.goals_a},
          {"goals_b", tie.goals_b},
          {"decided_by", tie.decided_by}};
}

/// All meetings that took place, each once.
Json crossJson(const TournamentTable& table) {
  Json json = Json::array();
  for (std::size_t a = 0; a < table.cross.size(); ++a) {
    for (std::size_t b = a + 1; b < table.cross.size(); ++b) {
      if (table.cross[a][b].pairs == 0) continue;
      Json meeting{{"a", a}, {"b", b}};
      meeting.update(meetingJson(table.cross[a][b]));
      // Follows from the ratings of all teams, not from this meeting alone.
      meeting["rated_superiority"] = table.ratings.superiority[a][b];
      json.push_back(std::move(meeting));
    }
  }
  return json;
}

Json notableJson(const TournamentState& state, const NotableMatch& match) {
  const Fixture& fixture = state.schedule.fixtures[match.fixture];
  return {{"pair", match.fixture},
          {"leg", match.leg + 1},
          {"id", match.id.text()},
          {"blue", entrantAt(fixture, match.leg, 0)},
          {"yellow", entrantAt(fixture, match.leg, 1)},
          {"start", bookEntry(state.plan.book, fixture.start).name},
          {"seed", state.results[match.fixture]->seed},
          {"why", match.why}};
}

template <typename List, typename Make>
Json listOf(const List& list, Make make) {
  Json json = Json::array();
  for (const auto& item : list) json.push_back(make(item));
  return json;
}

Json tableJson(const TournamentState& state, const TournamentTable& table) {
  const std::size_t counted = countedFixtures(state).size();
  Json json{{"schema_version", kTournamentSchemaVersion},
            {"tournament", state.plan.name},
            {"format", nameOf(state.plan.format)},
            {"finished", state.finished()},
            {"pairs_planned", state.schedule.fixtures.size()},
            {"all_planned", state.schedule.complete},
            {"pairs_counted", counted}};
  json["entrants"] = Json::array();
  for (std::size_t i = 0; i < state.plan.entrants.size(); ++i)
    json["entrants"].push_back(entrantJson(state, table, i));
  json["standings"] = listOf(table.standings, standingJson);
  json["bracket"] = listOf(table.bracket, tieJson);
  json["meetings"] = crossJson(table);
  json["draw_share"] = table.ratings.draw_share;
  json["prior"] = table.ratings.prior;
  json["notable"] = listOf(table.notable, [&](const NotableMatch& m) { return notableJson(state, m); });
  json["unplayed"] = unplayedJson(state.unplayed);
  json["seed"] = state.plan.seed;
  json["config"] = configJson(state.plan);
  return json;
}

}  // namespace

std::string tournamentJson(const TournamentState& state, const TournamentTable& table) {
  if (state.plan.format == TournamentFormat::kMatch) return matchReportJson(state);
  return indented(tableJson(state, table), 0) + '\n';
}

}  // namespace fulbito
