#include "replays/verify/verify_many.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "engine/core/system/worker_threads.hpp"

namespace fulbito {

Result<std::vector<std::string>> recordingFiles(const std::vector<std::string>& files_or_folders) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& name : files_or_folders) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> found;
    for (fs::directory_iterator entry(name, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == ".fbr") found.push_back(entry->path().string());
    }
    if (error) return fail(ioCode(error.value()), fmt::format("{}: {}", name, error.message()));
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

Result<std::vector<VerifiedFile>> verifyRecordings(
    const std::vector<std::string>& files, int jobs,
    const std::function<bool(std::size_t done, std::size_t total)>& watcher) {
  std::vector<VerifiedFile> results;
  results.reserve(files.size());
  for (const std::string& file : files) results.push_back({file, Verification{}});
  WorkProgress progress(watcher, files.size());
  const auto done = parallelFor(jobs, files.size(), progress, [&](std::size_t i) -> Result<void> {
    auto verified = verifyRecording(files[i]);
    // An unreadable file is a result; an interruption is not.
    if (!verified && verified.error().code == ErrorCode::kInterrupted) {
      return tl::unexpected<Error>(verified.error());
    }
    results[i].result = std::move(verified);
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return results;
}

}  // namespace fulbito
