#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fulbito {

/// " Did you mean 'x'?" for the candidate nearest to `word` by edit distance; empty if none is near. Near: at
/// most a third of the letters differ (at least one may), or `word` is a prefix. Case is ignored.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace fulbito
