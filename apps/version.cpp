#include <cstdio>

#include <fmt/format.h>

#include "apps/commands.hpp"
#include "engine/core/build_info.hpp"
#include "experiments/report.hpp"

namespace fulbito::app {

int version(bool json) {
  if (json) {
    std::fputs(versionJson().c_str(), stdout);
  } else {
    const BuildInfo& build = buildInfo();
    fmt::print("fulbito {} ({}, {}, Box2D {})\n", build.version, build.compiler, build.type, build.box2d);
  }
  return kOk;
}

}  // namespace fulbito::app
