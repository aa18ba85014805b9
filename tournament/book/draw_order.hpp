#pragma once

#include <cstddef>

#include "tournament/book/book.hpp"

namespace fulbito {

/// Which of `count` cases (at most 8) start `key` takes. Each block of `count` turns has every case once, in
/// an order drawn from the book's seed.
std::size_t caseOf(const StartKey& key, std::size_t count);

/// The index of the random stream that a start draws from. Every kind has its own indices.
std::uint64_t drawIndex(StartKind kind, std::uint64_t number);

}  // namespace fulbito
