#pragma once

#include <string>

#include "tournament/tune/tune_run.hpp"

namespace fulbito::app {

/// Draws the path of a tuning: all parameters over the iterations, as shares of their ranges. Errors: as
/// `Canvas`; kIo.
Result<void> writeTuneChart(const TunePlan& plan, const TuneOutcome& outcome, const std::string& file);

}  // namespace fulbito::app
