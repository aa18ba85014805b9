#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tournament/results/results.hpp"

namespace fulbito {

/// Two runs of one match that differ.
struct MatchConflict {
  MatchRow first, second;
  std::string first_file, second_file;
};

/// The union of logs.
struct MergedLogs {
  /// By identity. Of rows with the same result, that with the lesser words (names, failures), so that the
  /// order of the files changes nothing.
  std::map<MatchId, MatchRow> rows;
  std::vector<MatchConflict> conflicts;  ///< each against the run that was read first
  std::size_t repeated = 0;              ///< rows whose match was there already, with the same result
  std::size_t torn = 0;                  ///< logs whose last line was torn
};

/// Unions logs by match id. Errors: as `readRows`.
Result<MergedLogs> mergeLogs(const std::vector<std::string>& files);

/// Writes a log with these rows, in the order of their identities: equal rows give equal bytes. It appears
/// complete or not at all, and not even a power failure loses it. Errors: kIo.
Result<void> writeMatchLog(const std::string& file, const std::map<MatchId, MatchRow>& rows);

}  // namespace fulbito
