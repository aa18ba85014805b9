#pragma once

#include <span>

#include "fulbito/report.hpp"

namespace fulbito {

/// All experiments by name. The list is empty in a build without them (`FULBITO_EXPERIMENTS`).
std::span<const PaperExperiment> paperExperiments();

}  // namespace fulbito
