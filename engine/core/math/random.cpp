#include "engine/core/math/random.hpp"

#include <cmath>

#include <Random123/philox.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {

Rng::Rng(std::uint64_t seed, Stream stream, std::uint64_t index)
    : seed_(seed), stream_(static_cast<std::uint32_t>(stream)), index_(index) {}

std::uint32_t Rng::bits32() {
  if (used_ == 4) {
    r123::Philox4x32 philox;
    const r123::Philox4x32::ctr_type counter = {
        {block_, stream_, static_cast<std::uint32_t>(index_), static_cast<std::uint32_t>(index_ >> 32)}};
    const r123::Philox4x32::key_type key = {
        {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
    const auto words = philox(counter, key);
    for (std::size_t i = 0; i < 4; ++i) words_[i] = words[i];
    ++block_;
    used_ = 0;
  }
  return words_[used_++];
}

std::uint64_t Rng::bits64() {
  const std::uint64_t high = bits32();
  return (high << 32) | bits32();
}

double Rng::uniform() { return static_cast<double>(bits64() >> 11) * 0x1p-53; }

double Rng::uniform(double low, double high) {
  const double value = low + (high - low) * uniform();
  return value < high ? value : low;
}

std::uint32_t Rng::below(std::uint32_t n) {
  if (n <= 1) return 0;
  // Lemire's method: the multiply maps 32 bits onto [0, n); the rejection removes the bias.
  const std::uint32_t threshold = (0u - n) % n;
  for (;;) {
    const std::uint64_t product = std::uint64_t{bits32()} * n;
    if (static_cast<std::uint32_t>(product) >= threshold) return static_cast<std::uint32_t>(product >> 32);
  }
}

double Rng::normal() {
  for (;;) {
    const double u = uniform(-1.0, 1.0), v = uniform(-1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * math::log(s) / s);
  }
}

}  // namespace fulbito
