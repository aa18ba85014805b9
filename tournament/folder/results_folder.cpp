#include "tournament/folder/results_folder.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/text_file.hpp"
#include "tournament/store/log_reader.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kLargestRecord = 16 << 20;  // [bytes]
constexpr std::size_t kMostChanges = 5;           // shown

std::string planFile(const std::string& folder) { return folder + "/plan.json"; }
std::string logFile(const std::string& folder) { return folder + "/matches.jsonl"; }

Result<PlanRecord> readRecord(const std::string& folder) {
  const auto text = readTextFile(planFile(folder), kLargestRecord);
  if (!text) return tl::unexpected<Error>(text.error());
  return parsePlanRecord(*text, planFile(folder));
}

std::string listed(const std::vector<std::string>& changes) {
  std::string text;
  for (std::size_t i = 0; i < changes.size() && i < kMostChanges; ++i) text += "\n  " + changes[i];
  if (changes.size() > kMostChanges) text += fmt::format("\n  and {} more", changes.size() - kMostChanges);
  return text;
}

bool holdsTournament(const std::string& folder) {
  std::error_code ignored;
  return std::filesystem::exists(planFile(folder), ignored);
}

/// Errors: kUsage if the folder belongs to another plan.
Result<std::vector<std::string>> compare(const std::string& folder, const PlanRecord& record) {
  const auto old = readRecord(folder);
  if (!old) return tl::unexpected<Error>(old.error());
  if (const auto changes = changesOf(old->plan, record.plan); !changes.empty()) {
    return fail(ErrorCode::kUsage,
                fmt::format("{} holds a tournament with another plan; name another folder, or go back to its "
                            "plan. What differs:{}",
                            folder, listed(changes)));
  }
  return changesOf(*old, record);
}

}  // namespace

Result<ResultsFolder> ResultsFolder::open(const std::string& path, const PlanRecord& record) {
  ResultsFolder folder{path, nullptr, {}};
  if (holdsTournament(path)) {
    auto changed = compare(path, record);
    if (!changed) return tl::unexpected<Error>(changed.error());
    folder.changed = std::move(*changed);
  } else if (auto made = prepareFolder(path); !made) {
    return tl::unexpected<Error>(made.error());
  }
  auto log = MatchLog::open(logFile(path));
  if (!log) return tl::unexpected<Error>(log.error());
  folder.log = std::move(*log);
  // Only once the log is locked: another run may be using the folder.
  if (auto written = writeFile(planFile(path), toJson(record)); !written) {
    return tl::unexpected<Error>(written.error());
  }
  return folder;
}

Result<FolderState> readFolder(const std::string& path) {
  auto record = readRecord(path);
  if (!record) return tl::unexpected<Error>(record.error());
  const auto matches = readMatchStore(logFile(path), true);
  if (!matches) return tl::unexpected<Error>(matches.error());
  TournamentState state = stateOf(record->plan, record->identity, **matches);
  return FolderState{std::move(*record), std::move(state)};
}

Result<MergedFolders> mergeFolders(const std::vector<std::string>& folders, const std::string& into) {
  auto first = readRecord(folders.front());
  if (!first) return tl::unexpected<Error>(first.error());
  std::vector<std::string> all = folders, logs;
  if (holdsTournament(into)) all.push_back(into);
  for (const std::string& folder : all) {
    auto changed = compare(folder, *first);
    if (!changed) return tl::unexpected<Error>(changed.error());
    if (!changed->empty()) {
      return fail(ErrorCode::kUsage, fmt::format("{} and {} were not played by the same teams:{}",
                                                 folders.front(), folder, listed(*changed)));
    }
    logs.push_back(logFile(folder));
  }
  if (!holdsTournament(into)) {
    // Runs that differ leave no new folder.
    auto merged = mergeLogs(logs);
    if (!merged) return tl::unexpected<Error>(merged.error());
    if (!merged->conflicts.empty()) return MergedFolders{0, std::move(merged->conflicts)};
  }
  // Locks the log against a run in the folder until all is there, and writes the plan.
  const auto locked = ResultsFolder::open(into, *first);
  if (!locked) return tl::unexpected<Error>(locked.error());
  auto merged = mergeLogs(logs);
  if (!merged) return tl::unexpected<Error>(merged.error());
  if (!merged->conflicts.empty()) return MergedFolders{0, std::move(merged->conflicts)};
  if (auto written = writeMatchLog(logFile(into), merged->rows); !written) {
    return tl::unexpected<Error>(written.error());
  }
  return MergedFolders{merged->rows.size(), {}};
}

}  // namespace fulbito
