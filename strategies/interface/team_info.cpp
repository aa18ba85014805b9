#include "strategies/interface/team_info.hpp"

#include <algorithm>

namespace fulbito {

Result<NavigatorChoice> takeNavigator(std::vector<Setting>& settings, const std::string& default_navigator) {
  std::string specification = default_navigator;
  for (const Setting& setting : settings) {
    if (setting.name == kNavigatorSetting) specification = setting.value;
  }
  std::erase_if(settings, [](const Setting& setting) { return setting.name == kNavigatorSetting; });
  std::replace(specification.begin(), specification.end(), '+', ',');
  return parseNavigator(specification);
}

}  // namespace fulbito
