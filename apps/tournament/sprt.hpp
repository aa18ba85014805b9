#pragma once

#include <string>

#include "apps/tournament/plan_settings.hpp"
#include "apps/tournament/report_files.hpp"
#include "apps/tournament/run_plan.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito sprt`: a tournament of two teams with a sequential test.
struct SprtCommand {
  std::string fresh;  ///< the new team
  std::string base;
  PlanSettings settings;
  RunFlags flags;
  ReportFiles files;
};

/// Adds `sprt`.
void addSprt(CLI::App& app, SprtCommand& options);

/// Runs the command and returns its exit code: 0 pass, 1 fail, 6 inconclusive.
int sprt(const SprtCommand& options);

}  // namespace fulbito::app
