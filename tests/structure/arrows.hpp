#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulbito::test {

/// A target of the build and what it may use from outside the project.
struct Library {
  std::string_view target;  ///< in CMake; empty where several have the folder's sources
  std::string_view folder;
  std::string_view what;                 ///< for readers of docs/architecture.md
  std::vector<std::string_view> others;  ///< third-party headers, in sources and private headers only
};

/// A folder of sources and the folders that it includes from. What those include is not implied.
struct Folder {
  std::string_view path;
  std::string_view what;  ///< for readers of docs/architecture.md
  std::vector<std::string_view> uses;
};

/// A public header and the folder that it belongs to: one that may include the header may include from there.
struct PublicHeader {
  std::string_view name;    ///< as in #include: fulbito/...
  std::string_view folder;  ///< of `folders()`
};

/// Where the public headers are; on everybody's include path.
inline constexpr std::string_view kPublicFolder = "sdk/include/";

/// All headers below `kPublicFolder`, the ones that get installed.
std::span<const PublicHeader> publicHeaders();

/// The folder that a file belongs to, by its path from the root or its name in #include.
std::string ownerOf(std::string_view path);

/// All libraries, from those that use nothing upwards.
std::span<const Library> libraries();

/// All folders with sources, library by library, in each from those that use nothing upwards.
std::span<const Folder> folders();

/// The innermost library that a folder is in; none where it is in none.
const Library* libraryOf(std::string_view folder);

/// The tables of docs/architecture.md, in Markdown.
std::string arrowTables();

}  // namespace fulbito::test
