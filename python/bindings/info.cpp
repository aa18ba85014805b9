#include <algorithm>
#include <nanobind/stl/string.h>

#include "fulbito/detail/build_info.hpp"
#include "fulbito/world.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

float engineProfileMilliseconds() {
  WorldConfig config;
  config.robots.resize(1);
  World world = valueOf(World::create(config));
  float longest = 0.0f;
  for (int i = 0; i < 1000; ++i) {
    world.step({});
    longest = std::max(longest, world.engineProfileMilliseconds());
  }
  return longest;
}

}  // namespace

void bindInfo(nb::module_& m) {
  m.def("version", [] { return buildInfo().version; }, "The version of the package, such as 0.1.0.");
  m.def("_engine_profile_milliseconds", &engineProfileMilliseconds,
        "[ms] Longest step of a small world by the engine's own clock: 0, since that clock is taken out.");
}

}  // namespace fulbito::python
