#pragma once

#include <vector>

#include "experiments/papers/localization/batch.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// The paper's bound of the deviation from the reference path [m].
inline constexpr double kPaperDeviation = 0.05;

/// The figures beside the paper's.
std::vector<PaperFigure> runFigures(const Batch& batch);

/// Tables of schemes and grounds, of rules of alignment, of all runs in rooms, and of refusals.
std::vector<ReportTable> runTables(const Batch& batch);

}  // namespace fulbito::localization
