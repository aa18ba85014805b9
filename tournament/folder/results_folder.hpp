#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tournament/folder/plan_record.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/store/match_log.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito {

/// The folder of a tournament: `plan.json`, `matches.jsonl`, `recordings`.
struct ResultsFolder {
  std::string path;
  std::unique_ptr<MatchLog> log;     ///< open for writing
  std::vector<std::string> changed;  ///< what has changed since the last run, see `changesOf`

  /// Creates the folder, or continues it. Errors: kUsage naming what differs, if it belongs to another plan;
  /// kIo; kBadInput; as `MatchLog::open`.
  static Result<ResultsFolder> open(const std::string& path, const PlanRecord& record);

  /// The folder of its recordings.
  static std::string recordingsOf(const std::string& path) { return path + "/recordings"; }
};

/// What a folder has, also while a tournament is running in it.
struct FolderState {
  PlanRecord record;
  TournamentState state;
};

/// Reads a folder. Errors: kIo; kBadInput.
Result<FolderState> readFolder(const std::string& path);

/// What became of a merge.
struct MergedFolders {
  std::size_t matches = 0;               ///< in the new folder
  std::vector<MatchConflict> conflicts;  ///< if there are any, no match was written
};

/// Unions the folders of shards of one plan into a folder, with what that folder holds of the plan already.
/// Errors: kUsage when the plans or the teams differ, saying how; kIo; kBadInput.
Result<MergedFolders> mergeFolders(const std::vector<std::string>& folders, const std::string& into);

}  // namespace fulbito
