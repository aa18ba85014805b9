#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fulbito/detail/state_hash.hpp"
#include "tournament/results/results.hpp"

/// Keys and checksum of a line, shared by its writer and its reader.
namespace fulbito::row {

/// The parts of a line, in the order in which they are written.
enum Part : std::size_t {
  kId,
  kTeamNames,
  kStart,
  kSeed,
  kScore,
  kWinner,
  kGoalsAfterFoul,
  kPlayTicks,
  kWallTicks,
  kCornerTicks,
  kPlay,
  kTicks,
  kHash,
  kOutcome,
  kFaults,
  kAbandoned,
  kSum
};
inline constexpr const char* kKeys[] = {
    "id",         "teams",      "start",        "seed", "score", "winner",     "goals_after_foul",
    "play_ticks", "wall_ticks", "corner_ticks", "play", "ticks", "final_hash", "outcome",
    "faults",     "abandoned",  "sum"};

/// The key of a count, and its member of `TeamFaults`.
struct FaultCount {
  const char* key;
  std::int64_t TeamFaults::* count;
};
inline constexpr FaultCount kCounts[] = {
    {"not_finite", &TeamFaults::not_finite}, {"no_navigator", &TeamFaults::no_navigator},
    {"saturated", &TeamFaults::saturated},   {"late", &TeamFaults::late},
    {"stale", &TeamFaults::stale},           {"failures", &TeamFaults::failures}};
inline constexpr const char* kFailure = "failure";
inline constexpr const char* kForfeited = "forfeited";

inline constexpr std::string_view kBeforeSum = R"(,"sum":")";
inline constexpr std::string_view kAfterSum = "\"}";
inline constexpr std::size_t kHashDigits = 16;
inline constexpr std::size_t kSumSize = kBeforeSum.size() + kHashDigits + kAfterSum.size();

/// The checksum of a line: a hash of the bytes before the checksum.
inline std::uint64_t sumOf(std::string_view bytes) {
  StateHash hash;
  hash.add(bytes);
  return hash.value();
}

}  // namespace fulbito::row
