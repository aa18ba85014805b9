#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tournament/results/results.hpp"

namespace fulbito {

/// Version of the format of a log's lines.
inline constexpr int kMatchLogVersion = 1;
/// Longest text in a row [bytes]; the middle of longer ones is left out. Teams outside the program determine
/// the texts of failures.
inline constexpr std::size_t kLongestRowText = 500;
/// Longest line that the reader accepts [bytes]. Written lines are shorter: six texts, with at most six bytes
/// per escaped byte.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 16;

/// The first line of a log, with its line end.
std::string_view logHeader();

/// The row as a log stores it. Bytes that are not UTF-8 become U+FFFD, long texts lose their middle, and
/// `abandoned` has the code kBadInput. A second call changes nothing.
MatchRow storedForm(MatchRow row);

/// Whether two runs of a match had the same result: equal values. The texts of failures may differ, as they
/// may contain process numbers or times.
bool sameResult(const MatchResult& a, const MatchResult& b);

/// The stored form of a row as a line of a log, with its line end: JSON with keys in a fixed order and a
/// checksum (docs/results-format.md).
std::string toLine(const MatchRow& row);

/// Whether the checksum of a line (without line end) is correct.
bool isIntact(std::string_view line);

/// The row of a line, with or without line end. Errors: kBadInput describing the problem, without the file
/// name.
Result<MatchRow> parseLine(std::string_view line);

}  // namespace fulbito
