#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fulbito/detail/parameters.hpp"
#include "fulbito/navigation.hpp"

namespace fulbito {

/// Parses `name=value,name=value`. Errors (kUsage) quote `whole`.
Result<std::vector<Setting>> parseSettings(const std::string& text, const std::string& whole);

/// Builds the registry's entry of a navigator class `N` with the parameter struct `P`.
template <typename P, typename N>
NavigatorInfo describeNavigator(const std::string& name, std::string summary, std::string source,
                                std::vector<Parameter<P>> parameters, bool plans_speed = false) {
  NavigatorInfo info{name, std::move(summary), std::move(source), plans_speed, specsOf(parameters), {}};
  info.make = [name, parameters = std::move(parameters)](
                  const std::vector<Setting>& settings) -> Result<std::unique_ptr<Navigator>> {
    P values;
    if (auto done = applySettings(parameters, settings, name, values); !done) {
      return tl::unexpected<Error>(done.error());
    }
    return std::unique_ptr<Navigator>(std::make_unique<N>(values));
  };
  return info;
}

}  // namespace fulbito
