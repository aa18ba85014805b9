#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "engine/core/system/text_file.hpp"
#include "fulbito/detail/build_info.hpp"
#include "fulbito/report.hpp"

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

std::optional<std::string> ExperimentRequest::find(std::string_view name) const {
  for (const Setting& setting : settings) {
    if (setting.name == name) return setting.value;
  }
  return std::nullopt;
}

std::vector<ReportColumn> columnsOf(const std::string& words) {
  std::vector<ReportColumn> columns;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    const std::size_t colon = word.find(':');
    columns.push_back({word.substr(0, colon)});
    if (colon != std::string::npos) columns.back().decimals = std::stoi(word.substr(colon + 1));
  }
  return columns;
}

void finishScene(ReportScene& scene) {
  PageScene& page = scene.page;
  // In the page's data, robots have numbers.
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

std::vector<ExperimentSetting> settingsOf(const std::vector<ParameterSpec>& parameters) {
  std::vector<ExperimentSetting> list;
  for (const ParameterSpec& spec : parameters) {
    const std::string unit = spec.unit.empty() ? "" : " [" + spec.unit + "]";
    list.push_back({spec.name, fmt::format("{}", spec.default_value), spec.doc + unit});
  }
  return list;
}

Result<const PaperExperiment*> findPaperExperiment(std::span<const PaperExperiment> all,
                                                   const std::string& name) {
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

Result<std::string> readSettingFile(const std::string& file, std::size_t max_bytes) {
  return readTextFile(file, max_bytes);
}

}  // namespace fulbito
