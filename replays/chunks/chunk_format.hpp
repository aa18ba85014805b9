#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"
#include "replays/coding/columns.hpp"

/// Parts of the chunk format that writer and reader share.
namespace fulbito {

/// The parts of a chunk, in the order of the file.
enum class Section : std::uint8_t {
  kPlays,
  kCommands,
  kTickHashes,
  kPlaying,
  kChecks,
  kEvents,
  kDrawings,
  kSamples
};
inline constexpr std::array<const char*, 8> kSectionNames{"plays",  "commands", "hashes",   "clock",
                                                          "checks", "events",   "drawings", "samples"};
constexpr std::size_t indexOf(Section section) { return static_cast<std::size_t>(section); }

/// How the columns of the tables are predicted: commands jump, bodies keep moving.
inline constexpr Trend kCommandTrend = Trend::kStays, kSampleTrend = Trend::kGoesOn;

/// Largest length of the clause or law of an event [bytes].
inline constexpr std::size_t kMaxClauseBytes = 100;

/// Number of columns of one body in the table of samples; a ball has no heading.
constexpr std::size_t sampleColumns(BodyKind kind) { return kind == BodyKind::kBall ? 2 : 3; }
inline std::size_t sampleColumns(const RecordingHeader& header) {
  std::size_t columns = 0;
  for (const RecordedBody& body : header.bodies) columns += sampleColumns(body.kind);
  return columns;
}

/// A heading in steps of `RecordingHeader::sample_turn`, from -turn / 2 to turn / 2 - 1.
inline std::int32_t headingSteps(double heading, const RecordingHeader& header) {
  const std::int32_t turn = header.sample_turn, half = turn / 2;
  return (wholeSteps(heading, sampleHeadingStep(header)) % turn + turn + half) % turn - half;
}

/// The number of ticks among first + 1 ... first + count that are multiples of `every`.
constexpr std::int64_t multiplesIn(Tick first, std::int64_t count, std::int64_t every) {
  return (first + count) / every - first / every;
}

inline void writeFlags(std::vector<std::uint8_t>::const_iterator flags, std::size_t count, ByteWriter& out) {
  for (std::size_t i = 0; i < count; i += 8) {
    unsigned byte = 0;
    for (std::size_t bit = 0; bit < 8 && i + bit < count; ++bit) {
      byte |= static_cast<unsigned>(flags[static_cast<std::ptrdiff_t>(i + bit)] != 0) << bit;
    }
    out.byte(static_cast<std::uint8_t>(byte));
  }
}

inline std::vector<std::uint8_t> readFlags(std::size_t count, ByteReader& in) {
  std::vector<std::uint8_t> flags(count);
  std::uint8_t byte = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 8 == 0) byte = in.byte();
    flags[i] = (byte >> (i % 8)) & 1;
  }
  return flags;
}

/// Writes up to eight numbers, most of which are 0: a bit mask, then the others. -0 counts as not 0.
template <std::size_t N>
void writeNumbers(const double (&values)[N], ByteWriter& out) {
  static_assert(N <= 8);
  unsigned mask = 0;
  for (std::size_t i = 0; i < N; ++i) {
    mask |= static_cast<unsigned>(std::bit_cast<std::uint64_t>(values[i]) != 0) << i;
  }
  out.byte(static_cast<std::uint8_t>(mask));
  for (std::size_t i = 0; i < N; ++i) {
    if ((mask >> i & 1) != 0) out.number(values[i]);
  }
}

template <std::size_t N>
void readNumbers(double* const (&values)[N], ByteReader& in) {
  const unsigned mask = in.byte();
  if ((mask >> N) != 0) in.fail();
  for (std::size_t i = 0; i < N; ++i) *values[i] = (mask >> i & 1) != 0 ? in.number() : 0.0;
}

}  // namespace fulbito
