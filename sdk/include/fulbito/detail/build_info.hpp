#pragma once

#include <string>

namespace fulbito {

/// Version and build settings of this library.
struct BuildInfo {
  std::string version;   ///< of the project
  std::string compiler;  ///< name and version
  std::string type;      ///< CMake build type
  std::string box2d;     ///< version of the library in use
};

/// Of the library that this program was linked with.
const BuildInfo& buildInfo();

}  // namespace fulbito
