#pragma once

#include <array>
#include <cstdint>

namespace fulbito {

/// A stream of random numbers. Streams of different numbers are independent, so each consumer has its own and
/// a new one does not shift the others. The library uses numbers below 1000: `Stream{1000}` and above are
/// free for others.
enum class Stream : std::uint32_t;

/// Counter-based random numbers (Philox4x32-10, Salmon et al., SC 2011): the n-th draw is a pure function of
/// (seed, stream, index, n). Distributions are the project's own, since the standard ones differ between
/// implementations. A stream repeats after 2^34 32-bit words.
class Rng {
 public:
  /// @param index  separates consumers of one stream, e.g. the number of a trial
  Rng(std::uint64_t seed, Stream stream, std::uint64_t index = 0);

  std::uint32_t bits32();
  std::uint64_t bits64();
  /// In [0, 1), 53 bits.
  double uniform();
  /// In [low, high), where high - low does not overflow; `low` when the interval is empty.
  double uniform(double low, double high);
  /// In [0, n), without bias; 0 when n <= 1.
  std::uint32_t below(std::uint32_t n);
  /// Standard normal (Marsaglia's polar method on the project's own log).
  double normal();
  double normal(double mean, double sigma) { return mean + sigma * normal(); }

 private:
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t index_;
  std::uint32_t block_ = 0;
  std::uint32_t used_ = 4;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace fulbito
