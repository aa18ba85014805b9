#include "tournament/identity/file_set.hpp"

#include <algorithm>
#include <cerrno>
#include <fnmatch.h>
#include <fstream>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStep = std::size_t{1} << 18;  // [bytes] per read
constexpr int kMostEntries = 100000;
constexpr std::string_view kCompiled = "__pycache__";
constexpr std::string_view kAnyFolders = "**";

tl::unexpected<Error> cannotRead(const fs::path& path, const std::error_code& reason) {
  return fail(ioCode(reason.value()), fmt::format("cannot read '{}': {}", path.string(), reason.message()));
}

tl::unexpected<Error> cannotRead(const fs::path& path, int reason) {
  return cannotRead(path, std::error_code(reason == 0 ? EIO : reason, std::generic_category()));
}

using Names = std::span<const std::string>;

std::vector<std::string> namesOf(std::string_view path) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    names.emplace_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

bool matches(Names pattern, Names path) {
  if (pattern.empty()) return path.empty();
  if (pattern.front() != kAnyFolders) {
    return !path.empty() && fnmatch(pattern.front().c_str(), path.front().c_str(), FNM_PERIOD) == 0 &&
           matches(pattern.subspan(1), path.subspan(1));
  }
  if (pattern.size() == 1) return !path.empty();
  for (std::size_t skipped = 0; skipped <= path.size(); ++skipped) {
    if (matches(pattern.subspan(1), path.subspan(skipped))) return true;
  }
  return false;
}

bool leavesFolder(const std::string& pattern) {
  const std::vector<std::string> names = namesOf(pattern);
  return names.front().empty() || std::find(names.begin(), names.end(), "..") != names.end();
}

bool counts(const fs::path& path) {
  const std::string name = path.filename().string();
  return !name.starts_with('.') && name != kCompiled;
}

Result<std::vector<std::string>> allFilesBelow(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code error;
  int entries = 0;
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (++entries > kMostEntries) {
      return fail(ErrorCode::kBadInput,
                  fmt::format("the folder '{}' has more than {} entries", folder.string(), kMostEntries));
    }
    if (!counts(at->path())) {
      at.disable_recursion_pending();
      continue;
    }
    if (std::error_code ignored; !at->is_regular_file(ignored)) continue;
    files.push_back(at->path().lexically_relative(folder).generic_string());
  }
  if (error) return cannotRead(folder, error);
  return files;
}

}  // namespace

Result<WideHashValue> fileHash(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) return cannotRead(file, error);
  if (!fs::is_regular_file(status)) {
    return fail(ErrorCode::kIo, fmt::format("cannot read '{}': it is no regular file", file.string()));
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) return cannotRead(file, errno);
  WideHash hash;
  std::vector<char> bytes(kStep);
  while (in) {
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    hash.addBytes({bytes.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (in.bad()) return cannotRead(file, errno);
  return hash.value();
}

bool matchesPattern(std::string_view pattern, std::string_view path) {
  return matches(namesOf(pattern), namesOf(path));
}

Result<std::set<std::string>> filesMatching(const fs::path& folder,
                                            const std::vector<std::string>& patterns) {
  std::set<std::string> chosen;
  if (patterns.empty()) return chosen;
  const auto files = allFilesBelow(folder);
  if (!files) return tl::unexpected<Error>(files.error());
  for (const std::string& pattern : patterns) {
    if (leavesFolder(pattern)) {
      return fail(ErrorCode::kBadInput, fmt::format("files: '{}' is outside the team's folder", pattern));
    }
    bool any = false;
    for (const std::string& file : *files) {
      if (!matchesPattern(pattern, file)) continue;
      chosen.insert(file);
      any = true;
    }
    if (!any) return fail(ErrorCode::kBadInput, fmt::format("files: there is no file '{}'", pattern));
  }
  return chosen;
}

}  // namespace fulbito
