#pragma once

#include <string>
#include <vector>

#include "apps/tournament/plan_settings.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito tune`.
struct TuneCommand {
  std::string team;
  std::string opponent;                 ///< opponent of both versions; empty: they meet each other
  std::vector<std::string> parameters;  ///< see `parametersOf`; empty: all numbers
  PlanSettings settings;                ///< its entrants are not used; `pairs` is the number per iteration
  int iterations = 100;
  double perturbation = 0.1;  ///< c_end, as share of the range
  double step = 0.0;          ///< r_end; 0: depends on the number of iterations
  int final_pairs = 200;
  int jobs = 0;
  std::string out;  ///< folder for the results; empty: results are not stored
  std::string png;  ///< file of the chart; empty: none
  bool json = false;
};

/// Adds `tune`.
CLI::App* addTune(CLI::App& app, TuneCommand& options);

/// Runs the command and returns its exit code, which does not depend on whether the team improved.
int tune(const TuneCommand& options);

}  // namespace fulbito::app
