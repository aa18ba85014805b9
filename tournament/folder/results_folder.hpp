#pragma once

#include <string>
#include <vector>

#include "tournament/folder/log_folder.hpp"
#include "tournament/folder/plan_record.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito {

/// Creates the folder of a tournament, or opens it to continue. Errors: kUsage naming the differences if the
/// folder belongs to another plan, or if it holds a tuning; kIo; kBadInput; as `MatchLog::open`.
Result<LogFolder> openResultsFolder(const std::string& folder, const PlanRecord& record);

/// Path of the folder with a tournament's recordings.
std::string recordingsOf(const std::string& folder);

/// The content of a tournament's folder. It may be read while the tournament is running.
struct FolderState {
  PlanRecord record;
  TournamentState state;
};

/// Reads a folder. Errors: kIo; kBadInput.
Result<FolderState> readFolder(const std::string& folder);

/// The outcome of a merge.
struct MergedFolders {
  std::size_t matches = 0;  ///< in the new folder
  /// Matches with different results in two folders; if there are any, nothing was written.
  std::vector<MatchConflict> conflicts;
};

/// Merges the folders of shards of one plan into the folder `into`, together with the results already there.
/// Errors: kUsage naming the differences when plans or teams differ; kIo; kBadInput.
Result<MergedFolders> mergeFolders(const std::vector<std::string>& folders, const std::string& into);

}  // namespace fulbito
