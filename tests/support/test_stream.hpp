#pragma once

#include "engine/core/math/random.hpp"

namespace fulbito::test {

/// The random stream of tests and surveys. `Stream` reserves the number 6 for it, so that no random numbers
/// of the program change a test.
inline constexpr Stream kTestStream{6};

}  // namespace fulbito::test
