#pragma once

#include <span>
#include <string>

#include "navigation/interface/parameters.hpp"
#include "navigation/pilot.hpp"

namespace fulbito {

/// Name of the navigator that is used where none is named.
inline constexpr const char* kDefaultNavigator = "bspline-time";

/// All navigation methods, in the order in which tables list them.
std::span<const NavigatorInfo> navigators();

/// Parameters that every method takes beside its own: `follower=preview|classic` and
/// `wall_escape=on|off`.
std::span<const ParameterSpec> commonParameters();

/// A specification such as `bezier:clearance=0.02,follower=classic`, taken apart and checked by name.
struct NavigatorChoice {
  const NavigatorInfo* info = nullptr;  ///< entry of `navigators()`
  std::string text;                     ///< as given
  std::vector<Setting> settings;        ///< the method's own
  bool classic_follower = false;
  bool wall_escape = true;
};

/// Errors: kUsage naming the unknown method or parameter, with a suggestion.
Result<NavigatorChoice> parseNavigator(const std::string& specification);

/// A fresh pilot for the choice.
Result<std::unique_ptr<Pilot>> makePilot(const NavigatorChoice& choice);

}  // namespace fulbito
