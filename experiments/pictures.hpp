#pragma once

#include <string>
#include <vector>

#include "experiments/comparison.hpp"

namespace fulbito {

/// A picture of a layout with the real paths of all trials given (same layout, one each navigator). Errors:
/// kIo.
Result<void> writePathPicture(const std::string& file, const std::string& title, const TrialConfig& config,
                              const std::vector<const TrialRecord*>& records,
                              const std::vector<std::string>& labels);

/// A picture of one trial.
Result<void> writeTrialPicture(const std::string& file, const TrialConfig& config, const TrialResult& result);

/// Writes all pictures of a comparison into `folder`: one for each layout whose traces were kept, and the
/// charts time.png and distance.png. Returns the file names, in order. Errors: kIo.
Result<std::vector<std::string>> writePictures(const Comparison& comparison, const std::string& folder);

}  // namespace fulbito
