#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// Where the whole lines of a log end.
struct LogEnd {
  std::uint64_t size = 0;  ///< [bytes] of header and whole lines; 0: not even a header
  bool torn = false;       ///< something came after them: a line that was being written when a machine died
};

/// Hears of each row of a log with the number of its line, from 1. An error ends the reading.
using RowReceiver = std::function<Result<void>(MatchRow row, std::size_t line)>;

/// Reads a log from a descriptor, at most a line at a time in memory. A last line without its end or with a
/// wrong checksum is left out, as no run was told that it is kept. Header lines count nowhere, so that logs
/// may be joined with `cat`. Errors: kIo; kBadInput naming file and line; of the receiver, with file and
/// line.
Result<LogEnd> readRows(int descriptor, const std::string& file, const RowReceiver& receive);
/// The same of a file. A missing file is an empty log if `may_miss`.
Result<LogEnd> readRows(const std::string& file, bool may_miss, const RowReceiver& receive);

/// Keeps rows in memory. Its error is kBadInput when a match is there with another result.
RowReceiver keepIn(MatchMemory& memory);

/// All matches of a log in its order, each once. A missing file is an empty log if `may_miss`. Errors: as
/// `readRows` and `keepIn`.
Result<std::vector<MatchRow>> readMatchLog(const std::string& file, bool may_miss = false);
/// The same, to find matches in: a log that is read while another run writes it.
Result<std::unique_ptr<MatchMemory>> readMatchStore(const std::string& file, bool may_miss = false);

}  // namespace fulbito
