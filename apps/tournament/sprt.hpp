#pragma once

#include <string>
#include <vector>

#include "apps/match/match_settings.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito sprt`.
struct SprtCommand {
  MatchSettings settings;                  ///< blue is the new team, yellow its base
  std::vector<double> bounds{-50.0, 0.0};  ///< normalized Elo of H0 and H1
  double alpha = 0.05;
  double beta = 0.05;
  int pairs = 1000;  ///< most pairs
  int jobs = 0;
  bool json = false;
};

/// Adds `sprt`.
CLI::App* addSprt(CLI::App& app, SprtCommand& options);

/// Runs the command and returns its exit code: 0 pass, 1 fail, 6 inconclusive.
int sprt(const SprtCommand& options);

}  // namespace fulbito::app
