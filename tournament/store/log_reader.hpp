#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// The end of the intact part of a log.
struct LogEnd {
  std::uint64_t size = 0;  ///< header and whole lines [bytes]; 0: even the header is incomplete
  bool torn = false;  ///< more bytes follow: a line that was being written when a program or machine died
};

/// Called with each row of a log and the number of its line, from 1. An error ends the reading.
using RowReceiver = std::function<Result<void>(MatchRow row, std::size_t line)>;

/// Reads a log from a descriptor, at most a line at a time in memory. Skips a last line that has no line end
/// or a wrong checksum: no run was told that this line is kept. Skips header lines everywhere, so that logs
/// may be joined with `cat`. Errors: kIo; kBadInput naming file and line; of the receiver, with file and
/// line.
Result<LogEnd> readRows(int descriptor, const std::string& file, const RowReceiver& receive);
/// Reads a log from a file. If `may_miss`, a missing file is an empty log.
Result<LogEnd> readRows(const std::string& file, bool may_miss, const RowReceiver& receive);

/// A receiver that stores rows in memory. Its error is kBadInput when a match is there with another result.
RowReceiver keepIn(MatchMemory& memory);

/// All matches of a log in its order, each once. If `may_miss`, a missing file is an empty log. Errors: as
/// `readRows` and `keepIn`.
Result<std::vector<MatchRow>> readMatchLog(const std::string& file, bool may_miss = false);
/// As `readMatchLog`, but as a store to find matches in. Another run may be writing the log.
Result<std::unique_ptr<MatchMemory>> readMatchStore(const std::string& file, bool may_miss = false);

}  // namespace fulbito
