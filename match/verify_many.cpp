#include "match/verify_many.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>

#include <fmt/format.h>

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
    if (error) return fail(ErrorCode::kIo, fmt::format("{}: {}", name, error.message()));
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

Result<std::vector<VerifiedFile>> verifyRecordings(
    const std::vector<std::string>& files, int jobs,
    const std::function<bool(std::size_t done, std::size_t total)>& progress) {
  std::vector<VerifiedFile> results;
  results.reserve(files.size());
  for (const std::string& file : files) results.push_back({file, Verification{}});
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::size_t done = 0;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < files.size() && !stop; i = next++) {
      auto verified = verifyRecording(files[i]);
      const std::scoped_lock lock(mutex);
      results[i].result = std::move(verified);
      if (progress && !progress(++done, files.size())) stop = true;
    }
  };
  {
    const auto cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const int threads = std::min<int>(jobs > 0 ? jobs : cores, static_cast<int>(files.size()));
    std::vector<std::jthread> workers;
    for (int i = 1; i < threads; ++i) workers.emplace_back(work);
    work();
  }
  if (stop && done < files.size()) return fail(ErrorCode::kInterrupted, "interrupted");
  return results;
}

}  // namespace fulbito
