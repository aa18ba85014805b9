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
  std::string opponent;                 ///< empty: the versions meet each other
  std::vector<std::string> parameters;  ///< see `parametersOf`; empty: all numbers
  PlanSettings settings;                ///< its entrants are not used; `pairs` per iteration
  int iterations = 100;
  double perturbation = 0.1;  ///< c_end, of the range
  double step = 0.0;          ///< r_end; 0: by the number of iterations
  int final_pairs = 200;
  int jobs = 0;
  std::string out;  ///< folder; empty: nothing is kept
  std::string png;  ///< file; empty: no picture
  bool json = false;
};

/// Adds `tune`.
CLI::App* addTune(CLI::App& app, TuneCommand& options);

/// Runs the command and returns its exit code: 0 whether or not the team got better.
int tune(const TuneCommand& options);

}  // namespace fulbito::app
