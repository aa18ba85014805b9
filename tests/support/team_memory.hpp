#pragma once

#include <cstdint>

namespace fulbito::test {

/// [bytes] that a team may have in a test; sanitizers reserve much more than they use.
#ifdef FULBITO_SANITIZED
inline constexpr std::uint64_t kTeamMemory = std::uint64_t{1} << 47;
#else
inline constexpr std::uint64_t kTeamMemory = std::uint64_t{1} << 28;
#endif

}  // namespace fulbito::test
