#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// The experiment `capture`: Choi & Lee (2005), curves of constant curvature and the capture of a moving
/// object.
PaperExperiment captureExperiment();

}  // namespace fulbito
