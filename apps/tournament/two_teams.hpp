#pragma once

#include <string>

#include "apps/tournament/plan_settings.hpp"
#include "apps/tournament/report_files.hpp"
#include "apps/tournament/run_plan.hpp"

namespace fulbito::app {

/// Plays a tournament of format match between two teams, writes its reports and returns the exit code.
int playTwoTeams(const std::string& first, const std::string& second, const PlanSettings& settings,
                 const RunFlags& flags, const ReportFiles& files);

}  // namespace fulbito::app
