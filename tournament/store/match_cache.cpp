#include "tournament/store/match_cache.hpp"

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/regular_file.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito {
namespace {

/// One folder for each first two digits, because some file systems are slow with many files in one folder.
std::string folderOf(const std::string& folder, const MatchId& id) {
  return fmt::format("{}/{}", folder, id.text().substr(0, 2));
}

std::string fileOf(const std::string& folder, const MatchId& id) {
  return fmt::format("{}/{}.jsonl", folderOf(folder, id), id.text());
}

/// Removes anything at the path of an entry that is not a file: a pipe, a device, a dangling link, an empty
/// folder. Returns whether a file can be created there.
bool makeRoom(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::is_regular_file(file, error) || !fs::exists(fs::symlink_status(file, error))) return true;
  return fs::remove(file, error) && !error;
}

}  // namespace

Result<MatchCache> MatchCache::open(const std::string& folder) {
  return prepareFolder(folder).map([&] { return MatchCache(folder); });
}

std::optional<MatchRow> MatchCache::find(const MatchId& id) const {
  auto rows = readMatchLog(fileOf(folder_, id), true);
  if (!rows || rows->size() != 1 || rows->front().id != id) return std::nullopt;
  return std::move(rows->front());
}

Result<Added> MatchCache::add(const MatchRow& row) const {
  if (const auto there = find(row.id)) {
    return sameResult(there->result, row.result) ? Added::kSame : Added::kDifferent;
  }
  const std::string folder = folderOf(folder_, row.id);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return ioFailure("create the folder", folder, error.value());
  // A path that cannot be freed counts as a missing entry: the cache is optional.
  if (!makeRoom(fileOf(folder_, row.id))) return Added::kNew;
  const auto written = writeFile(fileOf(folder_, row.id), std::string(logHeader()) + toLine(row));
  return written.map([] { return Added::kNew; });
}

}  // namespace fulbito
