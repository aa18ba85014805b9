#pragma once

#include "experiments/comparison/comparison.hpp"
#include "replays/html/html_page.hpp"

namespace fulbito {

/// Every layout of a comparison whose traces were kept as a race: all navigators of its block at once, in the
/// HTML viewer. Errors: kUsage when no trace was kept; as `trialConfig`.
Result<Page> racePage(const Comparison& comparison);

}  // namespace fulbito
