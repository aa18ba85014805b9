#include "tournament/folder/log_folder.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/text_file.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kLargestRecord = 16 << 20;  // [bytes]
constexpr std::size_t kMostChanges = 5;           // changes that a message lists

/// Checks that the folder does not keep the other kind of work. Errors: kUsage.
Result<void> checkOtherWork(const std::string& folder, FolderWork work) {
  const bool tuning = work == FolderWork::kTuning;
  if (!keeps(folder, tuning ? FolderWork::kTournament : FolderWork::kTuning)) return {};
  return fail(ErrorCode::kUsage,
              fmt::format("{} holds a {}; name another folder", folder, tuning ? "tournament" : "tuning"));
}

}  // namespace

std::string recordFile(const std::string& folder, FolderWork work) {
  return folder + (work == FolderWork::kTuning ? "/tune.json" : "/plan.json");
}

std::string logFile(const std::string& folder) { return folder + "/matches.jsonl"; }

bool keeps(const std::string& folder, FolderWork work) {
  std::error_code ignored;
  return std::filesystem::exists(recordFile(folder, work), ignored);
}

Result<std::string> readRecordText(const std::string& folder, FolderWork work) {
  return readFoundFile(recordFile(folder, work), kLargestRecord);
}

std::string withChanges(const std::string& head, const std::vector<std::string>& changes) {
  std::string text = head + " What differs:";
  for (std::size_t i = 0; i < changes.size() && i < kMostChanges; ++i) text += "\n  " + changes[i];
  if (changes.size() > kMostChanges) text += fmt::format("\n  and {} more", changes.size() - kMostChanges);
  return text;
}

Result<LogFolder> openLogFolder(const std::string& folder, FolderWork work, const std::string& record,
                                const std::function<Result<std::vector<std::string>>()>& compare) {
  LogFolder opened;
  if (auto checked = checkOtherWork(folder, work); !checked) return tl::unexpected<Error>(checked.error());
  if (keeps(folder, work)) {
    auto changed = compare();
    if (!changed) return tl::unexpected<Error>(changed.error());
    opened.changed = std::move(*changed);
  } else if (auto made = prepareFolder(folder); !made) {
    return tl::unexpected<Error>(made.error());
  }
  auto log = MatchLog::open(logFile(folder));
  if (!log) return tl::unexpected<Error>(log.error());
  opened.log = std::move(*log);
  // Written only after the log is locked, because another run may be using the folder.
  if (auto written = writeFile(recordFile(folder, work), record); !written) {
    return tl::unexpected<Error>(written.error());
  }
  return opened;
}

}  // namespace fulbito
