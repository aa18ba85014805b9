#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Name of the file in a team's folder that lists the files of the team.
inline constexpr const char* kTeamFile = "team.toml";

/// The content of a `team.toml`; every key may be missing.
struct TeamFile {
  std::string name;                ///< name to show to people
  std::string version;             ///< version of the team; part of its identity
  std::vector<std::string> files;  ///< file patterns relative to the folder, see `filesMatching`
  bool deterministic = true;  ///< false: equal matches may differ; their results are never taken from a cache
};

/// Parses a `team.toml`; `origin` stands for the file name in errors. Errors: kBadInput as `file:line: key
/// ...` for unknown keys and wrong types.
Result<TeamFile> parseTeamFile(std::string_view text, const std::string& origin);

}  // namespace fulbito
