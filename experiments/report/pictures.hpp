#pragma once

#include <string>
#include <vector>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// A picture of layout `index` of a block with the real paths of its trials. A named case of the paper has
/// its figure's title, a caption that says what the figure shows and what the run does, the field's arrows
/// and only the runs that matter. Errors: kIo; kUsage when the traces were not kept.
Result<void> writePathPicture(const std::string& file, const Comparison& comparison, std::size_t block,
                              std::uint64_t index);

/// A picture of one trial, with the arrows of a method that is a field.
Result<void> writeTrialPicture(const std::string& file, const TrialConfig& config, const TrialResult& result);

/// Writes all pictures of a comparison into `folder`: one for each layout whose traces were kept, and the
/// charts time.png and distance.png. Returns the file names, in order. Errors: kIo.
Result<std::vector<std::string>> writePictures(const Comparison& comparison, const std::string& folder);

}  // namespace fulbito
