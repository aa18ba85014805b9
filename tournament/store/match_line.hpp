#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tournament/results/results.hpp"

namespace fulbito {

/// Version of the lines of a log.
inline constexpr int kMatchLogVersion = 1;
/// Longest text of a row [bytes]; longer ones lose their middle. Failures come from teams outside the
/// program.
inline constexpr std::size_t kLongestRowText = 500;
/// Longest line that is read [bytes]. Written ones are shorter: six texts, each byte escaped with six.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 16;

/// The first line of a log, with its line end.
std::string_view logHeader();

/// The row as a log keeps it: bytes that are not UTF-8 become U+FFFD, long texts lose their middle, and
/// `abandoned` has the code kBadInput. A second call changes nothing.
MatchRow storedForm(MatchRow row);

/// Whether two runs of a match had the same result: all values, but not the words of a failure. These may
/// tell process numbers or times.
bool sameResult(const MatchResult& a, const MatchResult& b);

/// The stored form of a row as a line of a log, with its line end: JSON with keys in a fixed order and a
/// checksum (docs/results-format.md).
std::string toLine(const MatchRow& row);

/// Whether a line without its end has the checksum of its bytes.
bool isIntact(std::string_view line);

/// The row of a line, with or without its end. Errors: kBadInput saying what is wrong, without the file.
Result<MatchRow> parseLine(std::string_view line);

}  // namespace fulbito
