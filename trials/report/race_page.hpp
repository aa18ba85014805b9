#pragma once

#include "fulbito/experiment.hpp"
#include "replays/html/html_page.hpp"

namespace fulbito {

/// A page for the HTML viewer with one race per layout with kept traces: all navigators of its block at once.
/// Errors: kUsage if no trace was kept; as `trialConfig`.
Result<Page> racePage(const Comparison& comparison);

}  // namespace fulbito
