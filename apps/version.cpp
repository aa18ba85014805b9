#include <cstdio>

#include <fmt/format.h>

#include "apps/commands.hpp"
#include "apps/console.hpp"
#include "engine/core/build_info.hpp"
#include "experiments/report.hpp"

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
