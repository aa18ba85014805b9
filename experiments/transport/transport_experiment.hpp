#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// "transport": Lee, Lee & Lee, cooperative motion planning of two tightly-coupled mobile robots. Settings:
/// path, step, loss, delay.
PaperExperiment transportExperiment();

}  // namespace fulbito
