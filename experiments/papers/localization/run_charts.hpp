#pragma once

#include <vector>

#include "experiments/papers/localization/batch.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// Deviation and heading error along the example's route for all schemes, and the constant over the
/// temperature for all rooms.
std::vector<ReportChart> runCharts(const Batch& batch);

}  // namespace fulbito::localization
