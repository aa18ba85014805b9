// Plays matches of all pairings of the built-in teams and compares every call with the second referee's.
//
//   second_referee MATCHES [HALF_SECONDS] [FIRST_SEED]
//
// Exit code 0: both agree on every call; 1: they do not, each disagreement is a line; 2: wrong arguments.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/second_referee/judge_matches.hpp"

namespace {

int judgeAll(int matches, double half_seconds, std::uint64_t seed) {
  fulbito::second::Verdict verdict;
  for (int i = 0; i < matches; ++i) fulbito::second::judgeMatch(i, half_seconds, seed, verdict);
  for (const std::string& line : verdict.disagreements) std::printf("%s\n", line.c_str());
  std::printf("%-26s %8s %12s %13s\n", "clause", "both", "match alone", "second alone");
  for (const auto& [clause, tally] : verdict.tallies) {
    std::printf("%-26s %8d %12d %13d\n", clause.c_str(), tally.both, tally.match_alone, tally.second_alone);
  }
  std::printf("second referee: %d matches, %d calls agreed on, %zu disagreements\n", verdict.matches,
              verdict.calls(), verdict.disagreements.size());
  return verdict.disagreements.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const int matches = argc > 1 ? std::atoi(argv[1]) : 0;
  const double half_seconds = argc > 2 ? std::atof(argv[2]) : 300.0;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (matches < 1 || !(half_seconds > 0.0)) {
    std::fprintf(stderr, "usage: second_referee MATCHES [HALF_SECONDS] [FIRST_SEED]\n");
    return 2;
  }
  try {
    return judgeAll(matches, half_seconds, seed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "second_referee: %s\n", error.what());
    return 1;
  }
}
