#include "fulbito/detail/build_info.hpp"

namespace fulbito {

const BuildInfo& buildInfo() {
#ifdef __clang__
  static const std::string compiler = "clang " __clang_version__;
#else
  static const std::string compiler = "gcc " __VERSION__;
#endif
  static const BuildInfo info{FULBITO_VERSION, compiler, FULBITO_BUILD_TYPE, FULBITO_BOX2D_VERSION};
  return info;
}

}  // namespace fulbito
