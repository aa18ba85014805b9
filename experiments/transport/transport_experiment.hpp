#pragma once

#include "experiments/papers/paper_experiment.hpp"

namespace fulbito {

/// "transport": Lee, Lee & Lee, cooperative motion planning of two tightly-coupled mobile robots. Settings:
/// path, step, loss, delay.
PaperExperiment transportExperiment();

}  // namespace fulbito
