#include "experiments/paper_experiments.hpp"

namespace fulbito {

std::span<const PaperExperiment> paperExperiments() { return {}; }

}  // namespace fulbito
