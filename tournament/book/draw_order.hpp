#pragma once

#include <cstddef>

#include "tournament/book/book.hpp"

namespace fulbito {

/// Which of `count` cases start `key` takes, at most 8: each block of `count` turns has every case once, in
/// an order of its own that the book's seed draws.
std::size_t caseOf(const StartKey& key, std::size_t count);

/// The stream index of a start's draws. Every kind has its own.
std::uint64_t drawIndex(StartKind kind, std::uint64_t number);

}  // namespace fulbito
