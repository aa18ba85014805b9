#pragma once

#include <string>
#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Writes a picture of layout `index` of a block with the driven paths of its trials. A case of the paper has
/// the figure's title, a caption with its statement and the result, the field's arrows, and only the relevant
/// runs. Errors: kIo; kUsage if the traces were not kept.
Result<void> writePathPicture(const std::string& file, const Comparison& comparison, std::size_t block,
                              std::uint64_t index);

/// Writes a picture of one trial, with the field's arrows for a field method.
Result<void> writeTrialPicture(const std::string& file, const TrialConfig& config, const TrialResult& result);

/// Writes all pictures of a comparison to `folder`: one per layout with kept traces, and the charts time.png
/// and distance.png. Returns the file names in order. Errors: kIo.
Result<std::vector<std::string>> writePictures(const Comparison& comparison, const std::string& folder);

}  // namespace fulbito
