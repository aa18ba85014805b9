#include "experiments/papers/paper_experiment.hpp"

#include <fmt/format.h>

#include "fulbito/detail/build_info.hpp"

namespace fulbito {

std::optional<std::string> ExperimentRequest::find(std::string_view name) const {
  for (const Setting& setting : settings) {
    if (setting.name == name) return setting.value;
  }
  return std::nullopt;
}

void finishScene(ReportScene& scene) {
  PageScene& page = scene.page;
  page.ticks = page.rows.empty() ? 0 : page.rows.back().tick;
  PagePlay play;
  play.present.assign(page.bodies.size(), 1);
  page.plays.push_back(std::move(play));
  page.facts.emplace_back("Made by", fmt::format("Fulbito {}", buildInfo().version));
}

}  // namespace fulbito
