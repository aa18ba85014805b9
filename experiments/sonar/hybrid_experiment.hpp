#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// The experiment `hybrid`: P.-G. Kim et al. (2006), obstacle avoidance with eight sonars by nearness
/// diagram, limit cycle and vector field.
PaperExperiment hybridExperiment();

}  // namespace fulbito
