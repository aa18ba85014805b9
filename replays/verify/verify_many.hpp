#pragma once

#include <functional>
#include <string>
#include <vector>

#include "replays/verify/verify.hpp"

namespace fulbito {

/// The result of one of many recordings.
struct VerifiedFile {
  std::string file;
  Result<Verification> result;
};

/// Replaces folders by the .fbr files in them, sorted by name; files stay as they are. Errors: kIo for
/// missing files and for folders that cannot be listed.
Result<std::vector<std::string>> recordingFiles(const std::vector<std::string>& files_or_folders);

/// Verifies recordings on `jobs` threads (0: all cores). Results are in the order of the files. `watcher` is
/// called with the number of finished ones, and stops the run by returning false. Errors: kInterrupted.
Result<std::vector<VerifiedFile>> verifyRecordings(
    const std::vector<std::string>& files, int jobs,
    const std::function<bool(std::size_t done, std::size_t total)>& watcher);

}  // namespace fulbito
