#include "strategies/registry.hpp"

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "strategies/teams/teams.hpp"

namespace fulbito {
std::span<const TeamInfo> teams() {
  static const std::vector<TeamInfo> entries = {idleInfo(), randomTeamInfo(), chaserInfo(), classicInfo(),
                                                liberoInfo()};
  return entries;
}

Result<TeamChoice> parseTeam(const std::string& specification) {
  const std::size_t colon = specification.find(':');
  const std::string name = specification.substr(0, colon);
  TeamChoice choice;
  choice.text = specification;
  std::vector<std::string> names;
  for (const TeamInfo& info : teams()) {
    if (info.name == name) choice.info = &info;
    names.push_back(info.name);
  }
  if (choice.info == nullptr) {
    return fail(ErrorCode::kUsage, fmt::format("there is no team '{}'.{}", name, suggestion(name, names)));
  }
  if (colon != std::string::npos) {
    auto settings = parseSettings(specification.substr(colon + 1), specification);
    if (!settings) return tl::unexpected<Error>(settings.error());
    choice.settings = std::move(*settings);
  }
  // Making one now reports a wrong parameter before anything runs.
  const auto trial = makeTeam(choice);
  if (!trial) return tl::unexpected<Error>(trial.error());
  return choice;
}

Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice) {
  return choice.info->make(choice.settings);
}

}  // namespace fulbito
