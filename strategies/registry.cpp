#include "strategies/registry.hpp"

#include <fmt/format.h>

#include "engine/core/suggest.hpp"
#include "strategies/chaser.hpp"
#include "strategies/libero.hpp"

namespace fulbito {

std::span<const TeamInfo> teams() {
  static const std::vector<TeamInfo> entries = {chaserInfo(), liberoInfo()};
  return entries;
}

Result<TeamChoice> parseTeam(const std::string& specification) {
  std::vector<std::string> names;
  const std::string name = specification.substr(0, specification.find(':'));
  for (const TeamInfo& info : teams()) {
    if (info.name == name) return TeamChoice{&info, specification, {}};
    names.push_back(info.name);
  }
  return fail(ErrorCode::kUsage, fmt::format("there is no team '{}'.{}", name, suggestion(name, names)));
}

Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice) {
  return choice.info->make(choice.settings);
}

}  // namespace fulbito
