#pragma once

#include <functional>
#include <string>
#include <vector>

#include "replays/verify/verify.hpp"

namespace fulbito {

/// One recording of many and its result.
struct VerifiedFile {
  std::string file;
  Result<Verification> result;
};

/// Expands folders to their .fbr files, sorted by name; files stay as they are. Errors: kIo for missing files
/// and folders that cannot be listed.
Result<std::vector<std::string>> recordingFiles(const std::vector<std::string>& files_or_folders);

/// Verifies each on `jobs` threads (0: all cores); results come in the order of the files. `watcher` hears
/// how many are done, and stops the run by returning false. Errors: kInterrupted.
Result<std::vector<VerifiedFile>> verifyRecordings(
    const std::vector<std::string>& files, int jobs,
    const std::function<bool(std::size_t done, std::size_t total)>& watcher);

}  // namespace fulbito
