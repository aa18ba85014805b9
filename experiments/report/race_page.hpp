#pragma once

#include "fulbito/experiment.hpp"
#include "replays/html/html_page.hpp"

namespace fulbito {

/// A page for the HTML viewer with one race per layout with kept traces, in which all navigators of its block
/// drive at once. Errors: kUsage if no trace was kept; as `trialConfig`.
Result<Page> racePage(const Comparison& comparison);

}  // namespace fulbito
