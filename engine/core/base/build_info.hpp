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

const BuildInfo& buildInfo();

}  // namespace fulbito
