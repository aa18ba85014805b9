#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tournament/store/match_log.hpp"

namespace fulbito {

/// A folder that keeps the matches of one piece of work, beside a record of what that work is.
struct LogFolder {
  std::unique_ptr<MatchLog> log;     ///< open for writing
  std::vector<std::string> changed;  ///< teams or engine that are not those of the last run
};

/// The work that a folder keeps.
enum class FolderWork : std::uint8_t { kTournament, kTuning };

/// The file of a folder with the record of its work: `plan.json` or `tune.json`.
std::string recordFile(const std::string& folder, FolderWork work);

/// The file of a folder with its matches.
std::string logFile(const std::string& folder);

/// Whether a folder keeps such work.
bool keeps(const std::string& folder, FolderWork work);

/// The text of the record of a folder. Errors: kIo; kBadInput if it is too long.
Result<std::string> readRecordText(const std::string& folder, FolderWork work);

/// A message: "HEAD What differs:", and the first changes, a line each.
std::string withChanges(const std::string& head, const std::vector<std::string>& changes);

/// Creates a folder, or continues it: then `compare` says what has changed since, or an error if the folder
/// belongs to other work. Errors: kUsage if it keeps work of another kind; of `compare`; kIo; as
/// `MatchLog::open`.
/// @param record  text of the record, written once the log is locked
Result<LogFolder> openLogFolder(const std::string& folder, FolderWork work, const std::string& record,
                                const std::function<Result<std::vector<std::string>>()>& compare);

}  // namespace fulbito
