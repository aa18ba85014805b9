#pragma once

#include <optional>

#include "apps/common/match_settings.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace fulbito::app {

/// Options of `fulbito serve --no-referee` alone.
struct SimulateOptions {
  std::optional<double> seconds;  ///< [s] simulated; empty: until a signal
};

/// Runs the league's simulator without a referee, prints a summary, and returns the exit code.
int simulate(const MatchSettings& settings, const wire::WireSettings& wire, const SimulateOptions& options,
             bool json);

}  // namespace fulbito::app
