#pragma once

#include <cstdlib>

namespace fulbito::test {

/// How many times the usual amount a test tries: the environment's FULBITO_REPETITIONS, which the tests of
/// label `soak` set; else once.
inline int repetitions() {
  const char* named = std::getenv("FULBITO_REPETITIONS");
  return named != nullptr ? std::atoi(named) : 1;
}

}  // namespace fulbito::test
