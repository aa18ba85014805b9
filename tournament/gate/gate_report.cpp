#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "match/report/match_json.hpp"
#include "tournament/gate/gate.hpp"
#include "tournament/report/json_parts.hpp"
#include "tournament/statistics/elo.hpp"

namespace fulbito {
namespace {

std::string intervalText(const Interval& interval) {
  return fmt::format("{:+.0f} ({:+.0f} to {:+.0f})", interval.value, interval.low, interval.high);
}

std::string meaningOf(const GateReport& report) {
  const SprtBounds& bounds = report.sprt.bounds();
  switch (report.sprt.verdict()) {
    case SprtVerdict::kPass:
      return fmt::format("rather {:+g} than {:+g} normalized Elo", bounds.strong, bounds.weak);
    case SprtVerdict::kFail:
      return fmt::format("rather {:+g} than {:+g} normalized Elo", bounds.weak, bounds.strong);
    case SprtVerdict::kInconclusive:
      break;
  }
  return report.series.interrupted ? "stopped before a verdict"
                                   : fmt::format("no verdict after {} pairs", report.series.pairs.size());
}

const std::string& nameOfTeam(const GateReport& report, std::size_t team) {
  return report.config.series.match.teams[team].text;
}

}  // namespace

std::string gateText(const GateReport& report) {
  const Sprt& sprt = report.sprt;
  const auto& n = sprt.counts().counts;
  const EloEstimate elo = estimateElo(sprt.counts());
  const SeriesResult& series = report.series;
  std::string text = fmt::format("{} against {}: {}, {}\n", nameOfTeam(report, 0), nameOfTeam(report, 1),
                                 nameOf(sprt.verdict()), meaningOf(report));
  text += fmt::format("  log-likelihood ratio   {:.2f}, pass at {:.2f}, fail at {:.2f}\n", sprt.ratio(),
                      sprt.bounds().upper(), sprt.bounds().lower());
  text += fmt::format("  pairs                  {}: LL {}, LD {}, LW+DD {}, DW {}, WW {}\n",
                      sprt.counts().pairs(), n[0], n[1], n[2], n[3], n[4]);
  text += fmt::format("  matches                {} won, {} drawn, {} lost, goals {}:{}\n", series.wins,
                      series.draws, series.losses, series.goals_for, series.goals_against);
  text += fmt::format("  Elo (95 %)             {}\n", intervalText(elo.elo));
  text += fmt::format("  normalized Elo (95 %)  {}\n", intervalText(elo.normalized_elo));
  text += fmt::format("  superiority            {:.1f} %\n", 100 * elo.superiority);
  return text;
}

std::string gateJson(const GateReport& report) {
  const Sprt& sprt = report.sprt;
  const SprtBounds& bounds = sprt.bounds();
  const EloEstimate elo = estimateElo(sprt.counts());
  const SeriesResult& series = report.series;
  const Json json{{"schema_version", kMatchSchemaVersion},
                  {"new", nameOfTeam(report, 0)},
                  {"base", nameOfTeam(report, 1)},
                  {"verdict", nameOf(sprt.verdict())},
                  {"complete", !series.interrupted},
                  {"log_likelihood_ratio", sprt.ratio()},
                  {"pass_at", bounds.upper()},
                  {"fail_at", bounds.lower()},
                  {"bounds", {bounds.weak, bounds.strong}},
                  {"alpha", bounds.alpha},
                  {"beta", bounds.beta},
                  {"pairs", sprt.counts().pairs()},
                  {"most_pairs", report.config.series.pairs},
                  {"counts", sprt.counts().counts},
                  {"wins", series.wins},
                  {"draws", series.draws},
                  {"losses", series.losses},
                  {"goals_for", series.goals_for},
                  {"goals_against", series.goals_against},
                  {"elo", intervalJson(elo.elo)},
                  {"normalized_elo", intervalJson(elo.normalized_elo)},
                  {"superiority", elo.superiority},
                  {"seed", report.config.series.match.seed},
                  {"config", matchConfigJson(report.config.series.match)},
                  {"build", buildJson()},
                  {"wall_s", report.wall}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fulbito
