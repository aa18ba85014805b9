#pragma once

#include <string>
#include <vector>

#include "experiments/papers/paper_experiment.hpp"

namespace fulbito {

/// Markdown for people: the figures beside the paper's, the tables, the notes.
std::string experimentText(const ExperimentReport& report);

/// One JSON object with figures, tables and names of files, pretty-printed with a final newline.
std::string experimentJson(const ExperimentReport& report, const ExperimentRequest& request);

/// The whole table as CSV.
std::string tableCsv(const ReportTable& table);

}  // namespace fulbito
