#include "tournament/folder/results_folder.hpp"

#include <fmt/format.h>

#include "tournament/store/log_reader.hpp"

namespace fulbito {
namespace {

Result<PlanRecord> readRecord(const std::string& folder) {
  const auto text = readRecordText(folder, FolderWork::kTournament);
  if (!text) return tl::unexpected<Error>(text.error());
  return parsePlanRecord(*text, recordFile(folder, FolderWork::kTournament));
}

/// Compares the folder's record with `record`. Errors: kUsage if the folder belongs to another plan.
Result<std::vector<std::string>> compare(const std::string& folder, const PlanRecord& record) {
  const auto old = readRecord(folder);
  if (!old) return tl::unexpected<Error>(old.error());
  const auto changes = changesOf(old->plan, record.plan);
  if (changes.empty()) return changesOf(*old, record);
  return fail(ErrorCode::kUsage,
              withChanges(folder + " holds a tournament with another plan; name another folder, or go "
                                   "back to its plan.",
                          changes));
}

}  // namespace

Result<LogFolder> openResultsFolder(const std::string& folder, const PlanRecord& record) {
  return openLogFolder(folder, FolderWork::kTournament, toJson(record),
                       [&] { return compare(folder, record); });
}

std::string recordingsOf(const std::string& folder) { return folder + "/recordings"; }

Result<FolderState> readFolder(const std::string& folder) {
  auto record = readRecord(folder);
  if (!record) return tl::unexpected<Error>(record.error());
  const auto matches = readMatchStore(logFile(folder), true);
  if (!matches) return tl::unexpected<Error>(matches.error());
  TournamentState state = stateOf(record->plan, record->identity, **matches);
  return FolderState{std::move(*record), std::move(state)};
}

Result<MergedFolders> mergeFolders(const std::vector<std::string>& folders, const std::string& into) {
  auto first = readRecord(folders.front());
  if (!first) return tl::unexpected<Error>(first.error());
  std::vector<std::string> all = folders, logs;
  if (keeps(into, FolderWork::kTournament)) all.push_back(into);
  for (const std::string& folder : all) {
    auto changed = compare(folder, *first);
    if (!changed) return tl::unexpected<Error>(changed.error());
    if (!changed->empty()) {
      return fail(ErrorCode::kUsage, withChanges(fmt::format("{} and {} were not played by the same teams.",
                                                             folders.front(), folder),
                                                 *changed));
    }
    logs.push_back(logFile(folder));
  }
  if (!keeps(into, FolderWork::kTournament)) {
    // Merges the logs first: if the runs conflict, no new folder is created.
    auto merged = mergeLogs(logs);
    if (!merged) return tl::unexpected<Error>(merged.error());
    if (!merged->conflicts.empty()) return MergedFolders{0, std::move(merged->conflicts)};
  }
  // Writes the plan, and keeps other runs out of the folder until all results are written.
  const auto locked = openResultsFolder(into, *first);
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
