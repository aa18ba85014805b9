#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "navigation/parameters.hpp"
#include "strategies/strategy.hpp"

namespace fulbito {

/// What the registry knows of one built-in team.
struct TeamInfo {
  std::string name;
  std::string summary;  ///< one line
  std::vector<ParameterSpec> parameters;
  bool takes_navigator = false;  ///< also takes `navigator=NAME`
  /// Makes the team from settings; errors: kUsage.
  std::function<Result<std::unique_ptr<Strategy>>(const std::vector<Setting>&)> make;
};

/// All built-in teams, in the order in which tables list them.
std::span<const TeamInfo> teams();

/// A specification such as `libero:navigator=bezier,aggression=0.7`, taken apart and checked.
struct TeamChoice {
  const TeamInfo* info = nullptr;  ///< entry of `teams()`
  std::string text;                ///< as given
  std::vector<Setting> settings;
};

/// Errors: kUsage naming the unknown team or parameter, with a suggestion.
Result<TeamChoice> parseTeam(const std::string& specification);

/// A fresh team for the choice. Errors: kUsage.
Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice);

}  // namespace fulbito
