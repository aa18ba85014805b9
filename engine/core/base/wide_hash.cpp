#include "engine/core/base/wide_hash.hpp"

#include <bit>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace fulbito {
namespace {

WideHashValue wordsOf(XXH128_hash_t hash) { return {hash.high64, hash.low64}; }

}  // namespace

struct WideHash::State {
  XXH3_state_t hash;
};

std::string hexText(const WideHashValue& value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(32);
  for (const std::uint64_t word : value) {
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(word >> shift) & 15U];
  }
  return text;
}

WideHashValue wideHash(std::string_view bytes) { return wordsOf(XXH3_128bits(bytes.data(), bytes.size())); }

WideHash::WideHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->hash); }
WideHash::~WideHash() = default;

void WideHash::addBytes(std::string_view bytes) {
  XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size());
}

void WideHash::add(std::string_view text) {
  add(std::uint64_t{text.size()});
  addBytes(text);
}

void WideHash::add(std::uint64_t value) {
  std::array<char, sizeof value> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(value >> (8 * i));
  addBytes({bytes.data(), bytes.size()});
}

void WideHash::add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }

WideHashValue WideHash::value() const { return wordsOf(XXH3_128bits_digest(&state_->hash)); }

}  // namespace fulbito
