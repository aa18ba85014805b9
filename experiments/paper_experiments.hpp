#pragma once

#include <span>

#include "fulbito/report.hpp"

namespace fulbito {

/// All experiments, in the order of docs/papers.md; none in a build without them.
std::span<const PaperExperiment> paperExperiments();

}  // namespace fulbito
