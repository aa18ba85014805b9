#include <cstdio>

#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "fulbito/detail/build_info.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::app {

int version(bool json) {
  if (json) {
    writeOut(versionJson());
  } else {
    const BuildInfo& build = buildInfo();
    say("fulbito {} ({}, {}, Box2D {})\n", build.version, build.compiler, build.type, build.box2d);
  }
  return kOk;
}

}  // namespace fulbito::app
