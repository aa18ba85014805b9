#include "apps/tournament/two_teams.hpp"

#include <fmt/format.h>

#include "apps/common/commands.hpp"

namespace fulbito::app {
namespace {

/// The settings of a tournament of two teams. If a team meets itself, its second entry gets another name.
PlanSettings settingsOf(const std::string& first, const std::string& second, PlanSettings settings) {
  settings.format = nameOf(TournamentFormat::kMatch);
  settings.name = fmt::format("{} against {}", first, second);
  settings.entrants = {{first, {}, {}}, {second, first == second ? second + " (2)" : "", {}}};
  return settings;
}

}  // namespace

int playTwoTeams(const std::string& first, const std::string& second, const PlanSettings& settings,
                 const RunFlags& flags, const ReportFiles& files) {
  if (auto checked = checkReportFiles(files); !checked) return report(checked.error());
  const auto plan = planOf(settingsOf(first, second, settings));
  if (!plan) return report(plan.error());
  const auto played = runPlan(*plan, flags);
  if (!played) return report(played.error());
  const RunOutcome& outcome = played->outcome;
  if (!flags.out.empty() || !outcome.mismatches.empty() || outcome.retried > 0) noteOutcome(*played, flags);
  const TournamentState& state = played->outcome.state;
  if (auto written = writeReports(state, files, flags.out); !written) {
    return report(written.error());
  }
  return exitCodeOf(*played, flags);
}

}  // namespace fulbito::app
