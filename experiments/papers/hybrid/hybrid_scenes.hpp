#pragma once

#include <string>

#include "experiments/papers/hybrid/hybrid_runs.hpp"

namespace fulbito::hybrid {

/// Both robots of a layout in one scene, each as if it were alone, with the sonar cones of the first. Errors:
/// of presets and worlds.
Result<ReportScene> hybridScene(const std::string& name, const std::string& title, const Layout& layout,
                                double speed, std::uint64_t seed, std::uint64_t index, bool with_rival);

}  // namespace fulbito::hybrid
