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

/// All libraries, from those that use nothing upwards.
std::span<const Library> libraries();

/// All folders with sources, library by library, in each from those that use nothing upwards.
std::span<const Folder> folders();

/// The innermost library that a folder is in; none where it is in none.
const Library* libraryOf(std::string_view folder);

/// The tables of docs/architecture.md, in Markdown.
std::string arrowTables();

}  // namespace fulbito::test
