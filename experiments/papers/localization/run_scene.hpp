#pragma once

#include <string>

#include "experiments/papers/localization/batch.hpp"
#include "fulbito/report.hpp"

namespace fulbito::localization {

/// A run with moments as an animated scene: the robot, a smaller one at its estimated pose, the echoes as
/// lines, and the reference path.
ReportScene runScene(const Ground& example, Scheme scheme, const std::string& name, const std::string& title);

}  // namespace fulbito::localization
