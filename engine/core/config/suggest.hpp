#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fulbito {

/// " Did you mean 'x'?" for the candidate nearest to `word` by edit distance, or an empty string where none
/// is near: at most a third of the letters wrong, one at least. Capitals do not count, a beginning of a
/// candidate is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace fulbito
