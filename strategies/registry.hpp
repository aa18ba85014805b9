#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "strategies/interface/team_info.hpp"

namespace fulbito {

/// All built-in teams, in the order in which tables list them.
std::span<const TeamInfo> teams();

/// A specification such as `libero:navigator=bezier,aggression=0.7`, taken apart and checked. A navigator's
/// own parameters follow with `+`: `classic:navigator=bezier:clearance=0.03+follower=classic`.
struct TeamChoice {
  const TeamInfo* info = nullptr;  ///< entry of `teams()`
  std::string text;                ///< as given
  std::vector<Setting> settings;
};

/// Errors: kUsage naming the unknown team, parameter or navigator, with a suggestion, or the allowed range.
Result<TeamChoice> parseTeam(const std::string& specification);

/// A fresh team for the choice. Errors: kUsage.
Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice);

}  // namespace fulbito
