#pragma once

#include <span>
#include <string>

#include "experiments/papers/paper_experiment.hpp"

namespace fulbito {

/// All experiments, in the order of docs/papers.md.
std::span<const PaperExperiment> paperExperiments();

/// The experiment of that name. Errors: kUsage with a suggestion.
Result<const PaperExperiment*> findPaperExperiment(const std::string& name);

/// Checks names of settings, and runs it. Errors: kUsage; those of the experiment.
Result<ExperimentReport> runPaperExperiment(const PaperExperiment& experiment,
                                            const ExperimentRequest& request);

}  // namespace fulbito
