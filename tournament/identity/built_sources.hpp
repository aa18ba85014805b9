#pragma once

#include <span>
#include <string_view>

namespace fulbito {

/// The hash of a group of the program's own sources.
struct SourceHash {
  std::string_view group;  ///< name of the group in tournament/identity/sources.txt
  std::string_view hash;   ///< 32 hexadecimal digits
};

/// The groups of tournament/identity/sources.txt, with their hashes at build time.
std::span<const SourceHash> builtSources();

/// The hash of a group; empty if there is no group with this name.
std::string_view sourcesOf(std::string_view group);

}  // namespace fulbito
