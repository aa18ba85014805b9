#include "experiments/paper_experiments.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "experiments/capture/capture_experiment.hpp"
#include "experiments/localization/localization_experiment.hpp"
#include "experiments/sonar/hybrid_experiment.hpp"
#include "experiments/transport/transport_experiment.hpp"

namespace fulbito {
namespace {

std::vector<std::string> namesOf(const auto& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

Result<void> checkSettings(const PaperExperiment& experiment, const std::vector<Setting>& settings) {
  const std::vector<std::string> known = namesOf(experiment.settings);
  for (const Setting& setting : settings) {
    if (std::find(known.begin(), known.end(), setting.name) != known.end()) continue;
    return fail(ErrorCode::kUsage, fmt::format("experiment {}: there is no setting '{}'.{}", experiment.name,
                                               setting.name, suggestion(setting.name, known)));
  }
  return {};
}

}  // namespace

std::span<const PaperExperiment> paperExperiments() {
  static const std::vector<PaperExperiment> kExperiments{
      captureExperiment(), hybridExperiment(), localization::localizationExperiment(), transportExperiment()};
  return kExperiments;
}

Result<const PaperExperiment*> findPaperExperiment(const std::string& name) {
  const auto all = paperExperiments();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == name; });
  if (found != all.end()) return &*found;
  return fail(ErrorCode::kUsage, fmt::format("there is no experiment '{}'.{} See fulbito experiment list.",
                                             name, suggestion(name, namesOf(all))));
}

Result<ExperimentReport> runPaperExperiment(const PaperExperiment& experiment,
                                            const ExperimentRequest& request) {
  if (auto checked = checkSettings(experiment, request.settings); !checked) {
    return tl::unexpected<Error>(checked.error());
  }
  return experiment.run(request);
}

}  // namespace fulbito
