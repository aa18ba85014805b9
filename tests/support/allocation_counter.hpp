#pragma once

#include <cstdint>

namespace fulbito::test {

/// Calls of the global `operator new` since the test program started; a program that links
/// allocation_counter.cpp replaces that operator.
std::uint64_t allocationCount();

}  // namespace fulbito::test
