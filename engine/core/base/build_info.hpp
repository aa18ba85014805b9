#pragma once

#include <string>

namespace fulbito {

/// What this library was built from and with.
struct BuildInfo {
  std::string version;   ///< of the project
  std::string compiler;  ///< name and version
  std::string type;      ///< CMake build type
  std::string box2d;     ///< version of the library in use
};

const BuildInfo& buildInfo();

}  // namespace fulbito
