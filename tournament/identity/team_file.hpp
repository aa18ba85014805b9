#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Name of the file beside a team that says what belongs to it.
inline constexpr const char* kTeamFile = "team.toml";

/// The content of a `team.toml`; every key may be missing.
struct TeamFile {
  std::string name;                ///< for people
  std::string version;             ///< part of the team's identity
  std::vector<std::string> files;  ///< patterns relative to its folder, see `filesMatching`
  bool deterministic = true;       ///< false: equal matches may differ; none is taken from a cache
};

/// Reads a `team.toml` from text; `origin` stands for the file name in errors. Errors: kBadInput as
/// `file:line: key ...` for unknown keys and wrong types.
Result<TeamFile> parseTeamFile(std::string_view text, const std::string& origin);

}  // namespace fulbito
