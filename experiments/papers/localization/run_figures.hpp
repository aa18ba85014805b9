#pragma once

#include <vector>

#include "experiments/papers/localization/batch.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// The paper's bound [m] of the deviation from the reference path.
inline constexpr double kPaperDeviation = 0.05;

/// Values for comparison with the paper's.
std::vector<PaperFigure> runFigures(const Batch& batch);

/// Tables of schemes and grounds, of alignment rules, of all runs in rooms, and of refusals.
std::vector<ReportTable> runTables(const Batch& batch);

}  // namespace fulbito::localization
