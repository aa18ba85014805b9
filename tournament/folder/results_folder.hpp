#pragma once

#include <string>
#include <vector>

#include "tournament/folder/log_folder.hpp"
#include "tournament/folder/plan_record.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito {

/// Creates the folder of a tournament, or continues it. Errors: kUsage naming what differs, if it belongs to
/// another plan, or if it holds a tuning; kIo; kBadInput; as `MatchLog::open`.
Result<LogFolder> openResultsFolder(const std::string& folder, const PlanRecord& record);

/// The folder of a tournament's recordings.
std::string recordingsOf(const std::string& folder);

/// What a folder has, also while a tournament is running in it.
struct FolderState {
  PlanRecord record;
  TournamentState state;
};

/// Reads a folder. Errors: kIo; kBadInput.
Result<FolderState> readFolder(const std::string& folder);

/// What became of a merge.
struct MergedFolders {
  std::size_t matches = 0;               ///< in the new folder
  std::vector<MatchConflict> conflicts;  ///< if there are any, no match was written
};

/// Unions the folders of shards of one plan into a folder, with what that folder holds of the plan already.
/// Errors: kUsage when the plans or the teams differ, saying how; kIo; kBadInput.
Result<MergedFolders> mergeFolders(const std::vector<std::string>& folders, const std::string& into);

}  // namespace fulbito
