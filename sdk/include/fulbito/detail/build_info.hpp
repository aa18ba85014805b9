#pragma once

#include <string>

namespace fulbito {

/// Version and build settings of this library.
struct BuildInfo {
  std::string version;   ///< version of the project
  std::string compiler;  ///< name and version
  std::string type;      ///< CMake build type
  std::string box2d;     ///< version of Box2D
};

/// The build of the linked library.
const BuildInfo& buildInfo();

}  // namespace fulbito
