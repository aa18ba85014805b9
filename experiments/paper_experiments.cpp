#include "experiments/paper_experiments.hpp"

#include <vector>

#include "experiments/capture/capture_experiment.hpp"
#include "experiments/localization/localization_experiment.hpp"
#include "experiments/sonar/hybrid_experiment.hpp"
#include "experiments/transport/transport_experiment.hpp"

namespace fulbito {

std::span<const PaperExperiment> paperExperiments() {
  static const std::vector<PaperExperiment> kExperiments{
      captureExperiment(), hybridExperiment(), localization::localizationExperiment(), transportExperiment()};
  return kExperiments;
}

}  // namespace fulbito
