#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulbito::test {

/// A public header and the folder that it belongs to: one that may include the header may include from there.
struct PublicHeader {
  std::string_view name;    ///< as in #include: fulbito/...
  std::string_view folder;  ///< from the repository's root
};

/// Where the public headers are; on everybody's include path.
inline constexpr std::string_view kPublicFolder = "sdk/include/";

/// All headers below `kPublicFolder`, the ones that get installed.
std::span<const PublicHeader> publicHeaders();

/// The folder that a file belongs to, by its path from the root or its name in #include.
std::string ownerOf(std::string_view path);

}  // namespace fulbito::test
