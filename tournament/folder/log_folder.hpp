#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tournament/store/match_log.hpp"

namespace fulbito {

/// A folder with the log of matches of a tournament or tuning, and a record that describes it.
struct LogFolder {
  std::unique_ptr<MatchLog> log;     ///< open for writing
  std::vector<std::string> changed;  ///< teams or engine that have changed since the last run
};

/// The kinds of work that a folder can keep.
enum class FolderWork : std::uint8_t { kTournament, kTuning };

/// Path of the record of a folder: `plan.json` or `tune.json`.
std::string recordFile(const std::string& folder, FolderWork work);

/// Path of the match log of a folder.
std::string logFile(const std::string& folder);

/// Whether a folder holds the record of this kind of work.
bool keeps(const std::string& folder, FolderWork work);

/// The text of the record of a folder. Errors: kIo; kBadInput if it is too long.
Result<std::string> readRecordText(const std::string& folder, FolderWork work);

/// A message of several lines: "HEAD What differs:", then the first changes, one per line.
std::string withChanges(const std::string& head, const std::vector<std::string>& changes);

/// Creates a folder, or opens an existing one to continue it. For an existing folder, `compare` returns what
/// has changed, or an error if the folder belongs to other work. Errors: kUsage if the folder keeps the other
/// kind of work; of `compare`; kIo; as `MatchLog::open`.
/// @param record  text of the record, written once the log is locked
Result<LogFolder> openLogFolder(const std::string& folder, FolderWork work, const std::string& record,
                                const std::function<Result<std::vector<std::string>>()>& compare);

}  // namespace fulbito
