#pragma once

#include <string>
#include <vector>

#include "fulbito/report.hpp"

namespace fulbito::app {

/// Writes results.json, a CSV file per table, a picture per chart and scene, a GIF per scene and NAME.html
/// into `folder`, and returns their names in order. Errors: kIo.
Result<std::vector<std::string>> writeExperiment(const ExperimentReport& report,
                                                 const ExperimentRequest& request, const std::string& folder);

}  // namespace fulbito::app
