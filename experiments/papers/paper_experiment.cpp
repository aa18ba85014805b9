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
  // The page calls its robots by numbers.
  for (std::size_t i = 0, robot = 0; i < scene.labels.size() && i < page.bodies.size(); ++i) {
    if (page.bodies[i].kind != BodyKind::kRobot) continue;
    page.facts.emplace_back(fmt::format("Robot {}", ++robot), scene.labels[i]);
  }
  page.ticks = page.rows.empty() ? 0 : page.rows.back().tick;
  PagePlay play;
  play.present.assign(page.bodies.size(), 1);
  page.plays.push_back(std::move(play));
  page.facts.emplace_back("Made by", fmt::format("Fulbito {}", buildInfo().version));
}

}  // namespace fulbito
