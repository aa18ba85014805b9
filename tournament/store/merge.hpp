#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tournament/results/results.hpp"

namespace fulbito {

/// Two rows of the same match with different results.
struct MatchConflict {
  MatchRow first, second;
  std::string first_file, second_file;
};

/// The union of logs.
struct MergedLogs {
  /// Rows by identity. Of several rows with the same result, the one whose texts (names, failures) sort
  /// first, so that the order of the files does not matter.
  std::map<MatchId, MatchRow> rows;
  std::vector<MatchConflict> conflicts;  ///< a later row of a match and the first one that was read
  std::size_t repeated = 0;              ///< rows whose match had already been read with the same result
  std::size_t torn = 0;                  ///< logs with an incomplete last line
};

/// Merges logs by match id. Errors: as `readRows`.
Result<MergedLogs> mergeLogs(const std::vector<std::string>& files);

/// Writes a log with these rows, in the order of their identities, so equal rows give equal bytes. The file
/// appears complete or not at all, and survives a power failure. Errors: kIo.
Result<void> writeMatchLog(const std::string& file, const std::map<MatchId, MatchRow>& rows);

}  // namespace fulbito
