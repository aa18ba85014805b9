#pragma once

namespace fulbito::test {

/// Calls of malloc and its kin since the program started, operator new's among them; a program that links
/// malloc_counter.cpp replaces glibc's.
long mallocCount();

}  // namespace fulbito::test
