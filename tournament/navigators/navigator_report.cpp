#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/text_controls.hpp"
#include "tournament/navigators/navigator_tournament.hpp"
#include "tournament/report/json_parts.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {
namespace {

constexpr int kSchemaVersion = 1;

const ComparisonBlock& blockOf(const NavigatorTournament& tournament) {
  return tournament.comparison.blocks.front();
}

const std::string& nameOf(const NavigatorTournament& tournament, std::size_t navigator) {
  return blockOf(tournament).navigators[navigator].text;
}

std::size_t longestName(const NavigatorTournament& tournament) {
  std::size_t longest = 9;  // length of the column head "navigator"
  for (const NavigatorChoice& choice : blockOf(tournament).navigators) {
    longest = std::max(longest, choice.text.size());
  }
  return longest;
}

/// A number with `digits` decimals, or a dash for NaN.
std::string figure(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

std::string signedInterval(const Interval& interval, int digits) {
  if (std::isnan(interval.value)) return "-";
  if (std::isnan(interval.low)) return fmt::format("{:+.{}f}", interval.value, digits);
  return fmt::format("{:+.{}f} ({:+.{}f} to {:+.{}f})", interval.value, digits, interval.low, digits,
                     interval.high, digits);
}

std::string percentInterval(const Interval& share) {
  return fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100 * share.value, 100 * share.low, 100 * share.high);
}

std::string resultsText(int won, int drawn, int lost) { return fmt::format("{}-{}-{}", won, drawn, lost); }

std::string pText(double p) { return p < 0.0001 ? "< 0.0001" : fmt::format("{:.4f}", p); }

std::string standingsText(const NavigatorTournament& tournament) {
  const std::size_t width = longestName(tournament);
  std::string text =
      fmt::format("{:>2}  {:{}}  {:>22}  {:>18}  {:>15}  {:>8}  {:>10}\n", "#", "navigator", width,
                  "Elo (95 %)", "arrived (95 %)", "won-drawn-lost", "time [s]", "length [m]");
  int rank = 0;
  for (const NavigatorStanding& row : tournament.table.standings) {
    text +=
        fmt::format("{:>2}  {:{}}  {:>22}  {:>18}  {:>15}  {:>8}  {:>10}\n", ++rank,
                    nameOf(tournament, row.navigator), width, eloText(row.elo), percentInterval(row.arrived),
                    resultsText(row.won, row.drawn, row.lost), figure(row.time, 3), figure(row.length, 3));
  }
  return text;
}

std::string meetingsText(const NavigatorTournament& tournament) {
  const std::size_t width = 2 * longestName(tournament) + 3;
  std::string text = fmt::format("{:{}}  {:>14}  {:>11}  {:>8}  {:>8}  {:>4}  {:>26}  {:>26}\n", "meeting",
                                 width, "won-drawn-lost", "superiority", "p", "p (Holm)", "both",
                                 "time [s] (95 %)", "length [m] (95 %)");
  for (const NavigatorMeeting& row : tournament.table.meetings) {
    const std::string names = nameOf(tournament, row.first) + " v " + nameOf(tournament, row.second);
    text +=
        fmt::format("{:{}}  {:>14}  {:>9.1f} %  {:>8}  {:>8}  {:>4}  {:>26}  {:>26}\n", names, width,
                    resultsText(row.won, row.drawn, row.lost), 100 * row.superiority, pText(row.p),
                    pText(row.p_holm), row.both, signedInterval(row.time, 3), signedInterval(row.length, 3));
  }
  return text;
}

Json standingsJson(const NavigatorTournament& tournament) {
  Json rows = Json::array();
  for (const NavigatorStanding& row : tournament.table.standings) {
    rows.push_back({{"rank", rows.size() + 1},
                    {"navigator", nameOf(tournament, row.navigator)},
                    {"elo", intervalJson(row.elo)},
                    {"arrived", intervalJson(row.arrived)},
                    {"won", row.won},
                    {"drawn", row.drawn},
                    {"lost", row.lost},
                    {"time_s", numberOrNull(row.time)},
                    {"path_length_m", numberOrNull(row.length)}});
  }
  return rows;
}

Json meetingsJson(const NavigatorTournament& tournament) {
  Json rows = Json::array();
  for (const NavigatorMeeting& row : tournament.table.meetings) {
    rows.push_back({{"first", nameOf(tournament, row.first)},
                    {"second", nameOf(tournament, row.second)},
                    {"won", row.won},
                    {"drawn", row.drawn},
                    {"lost", row.lost},
                    {"superiority", row.superiority},
                    {"p", row.p},
                    {"p_holm", row.p_holm},
                    {"both_arrived", row.both},
                    {"time_difference_s", intervalJson(row.time)},
                    {"path_length_difference_m", intervalJson(row.length)}});
  }
  return rows;
}

Json configJson(const NavigatorTournament& tournament) {
  const ComparisonConfig& config = tournament.comparison.config;
  return {{"robot", config.robot},
          {"physics", config.physics},
          {"latency_ticks", config.sensors.latency_ticks},
          {"noise_m", config.sensors.position_noise},
          {"dropout", config.sensors.dropout}};
}

}  // namespace

std::string navigatorTournamentText(const NavigatorTournament& tournament) {
  const NavigatorTable& table = tournament.table;
  std::string text =
      fmt::format("suite {}, {} layouts at {} m/s, seed {}\n\n", tournament.comparison.config.suite,
                  table.layouts, blockOf(tournament).speed, blockOf(tournament).seed);
  text += standingsText(tournament) + "\n" + meetingsText(tournament) + "\n";
  text += fmt::format("Time and length of navigators: means over the {} layouts on which all arrived;\n",
                      table.common);
  text += "of meetings: mean differences, first minus second, where both arrived.\n";
  text += fmt::format("A layout is drawn if both fail or arrive within {:.0f} ms of each other.\n",
                      1000 * tournament.tie);
  if (table.prior) {
    text +=
        "One navigator, or a group, won or lost everything: its Elo rests on a prior "
        "(docs/tournaments.md).\n";
  }
  return text;
}

std::string navigatorTournamentJson(const NavigatorTournament& tournament) {
  const NavigatorTable& table = tournament.table;
  const Json json{{"schema_version", kSchemaVersion},
                  {"suite", tournament.comparison.config.suite},
                  {"speed", blockOf(tournament).speed},
                  {"layouts", table.layouts},
                  {"seed", blockOf(tournament).seed},
                  {"tie_s", tournament.tie},
                  {"layouts_all_arrived", table.common},
                  {"draw_share", table.draw_share},
                  {"prior", table.prior},
                  {"standings", standingsJson(tournament)},
                  {"meetings", meetingsJson(tournament)},
                  {"config", configJson(tournament)},
                  {"build", buildJson()}};
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace fulbito
