#include <cstdio>

#include "bench/benchmark.hpp"

int main() {
  std::fputs(fulbito::toTable(fulbito::runBenchmark({})).c_str(), stdout);
  return 0;
}
