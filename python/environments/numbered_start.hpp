#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fulbito {

/// What a text such as `trial 7 of seed 3` or `layout fig4-wall` names.
struct NumberedStart {
  std::string_view name;                ///< what follows the word: a number or a name
  std::optional<std::uint64_t> number;  ///< of that name, if it is one
  std::uint64_t seed = 0;
};

/// Reads `WORD NAME` or `WORD NAME of seed SEED`; empty if the text is neither.
/// @param seed  where the text has none
std::optional<NumberedStart> readNumberedStart(std::string_view text, std::string_view word,
                                               std::uint64_t seed);

}  // namespace fulbito
