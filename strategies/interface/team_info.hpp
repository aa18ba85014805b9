#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fulbito/navigation.hpp"
#include "fulbito/strategy.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {

/// Name of the setting that chooses a team's navigator.
inline constexpr const char* kNavigatorSetting = "navigator";
/// Name of the setting that leaves skills of a team's play book out, such as `without=race+squeeze`.
inline constexpr const char* kWithoutSetting = "without";

/// Removes the setting `navigator` from a team's settings and returns its choice, or that of
/// `default_navigator`. Errors: kUsage.
Result<NavigatorChoice> takeNavigator(std::vector<Setting>& settings, const std::string& default_navigator);

/// Builds the catalogue's entry of a team class `S` with the parameter struct `P`.
template <typename P, typename S>
TeamInfo describeTeam(const std::string& name, std::string summary, std::vector<Parameter<P>> parameters) {
  TeamInfo info{name, std::move(summary), specsOf(parameters), false, {}, {}, false};
  info.make = [name, parameters = std::move(parameters)](
                  const std::vector<Setting>& settings) -> Result<std::unique_ptr<Strategy>> {
    P values;
    if (auto done = applySettings(parameters, settings, name, values); !done) {
      return tl::unexpected<Error>(done.error());
    }
    return std::unique_ptr<Strategy>(std::make_unique<S>(values));
  };
  return info;
}

/// Builds the entry of a team that drives with a navigator of the registry: the constructor of `S` takes its
/// parameters and the navigator's choice.
template <typename P, typename S>
TeamInfo describeTeam(const std::string& name, std::string summary, std::vector<Parameter<P>> parameters,
                      std::string default_navigator) {
  TeamInfo info{name, std::move(summary), specsOf(parameters), true, default_navigator, {}, false};
  info.make = [name, parameters = std::move(parameters), default_navigator = std::move(default_navigator)](
                  std::vector<Setting> settings) -> Result<std::unique_ptr<Strategy>> {
    const auto navigator = takeNavigator(settings, default_navigator);
    if (!navigator) return tl::unexpected<Error>(navigator.error());
    P values;
    if (auto done = applySettings(parameters, settings, name, values, {kNavigatorSetting}); !done) {
      return tl::unexpected<Error>(done.error());
    }
    return std::unique_ptr<Strategy>(std::make_unique<S>(values, *navigator));
  };
  return info;
}

}  // namespace fulbito
