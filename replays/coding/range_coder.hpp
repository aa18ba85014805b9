#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "replays/coding/byte_io.hpp"

/// An adaptive binary range coder (Martin, 1979; with LZMA's delayed carry): a bit of probability p costs
/// -log2 p bits. Writing and reading share their code through a `Coder` template parameter: `bit` and `bits`
/// take the value when writing and return it when reading.
namespace fulbito {

/// Adaptive probability of a bit of one kind; adapts fast at first.
class BitModel {
 public:
  /// Probability of a 1 in units of 1/65536, never 0 or 1.
  std::uint32_t chance() const { return chance_; }
  void learn(unsigned bit) {
    const std::uint32_t rate = kRates[seen_];
    // Branch-free: the branch would mispredict on high-entropy bits.
    const std::uint32_t up = (kMost - chance_) * rate >> 16, down = (chance_ - kLeast) * rate >> 16;
    chance_ = static_cast<std::uint16_t>(bit != 0 ? chance_ + up : chance_ - down);
    seen_ = static_cast<std::uint8_t>(seen_ + (seen_ + 1u < kRates.size() ? 1 : 0));
  }

 private:
  static constexpr std::uint32_t kLeast = 48, kMost = 65536 - kLeast;
  /// Share of the way to the new bit after n bits: 1 / (n + 1.6) in 1/65536, down to about 1/40.
  static constexpr std::array<std::uint16_t, 39> kRates = [] {
    std::array<std::uint16_t, 39> rates{};
    for (std::uint32_t n = 0; n < rates.size(); ++n) {
      rates[n] = static_cast<std::uint16_t>(655360u / (10 * n + 16));
    }
    return rates;
  }();
  std::uint16_t chance_ = 32768;
  std::uint8_t seen_ = 0;
};

class RangeEncoder {
 public:
  explicit RangeEncoder(Bytes& out) : out_(out) {}

  unsigned bit(BitModel& model, unsigned value) {
    const std::uint32_t bound = (range_ >> 16) * model.chance();
    low_ += value != 0 ? 0 : bound;
    range_ = value != 0 ? bound : range_ - bound;
    model.learn(value);
    while (range_ < kLeastRange) shift();
    return value;
  }
  /// The lowest `count` bits of a value, with equal probabilities of 0 and 1.
  std::uint64_t bits(std::uint64_t value, int count) {
    for (int left = count; left > 0;) {
      const int part = left < 16 ? left : 16;
      left -= part;
      range_ >>= part;
      low_ += (value >> left & ((1u << part) - 1)) * std::uint64_t{range_};
      while (range_ < kLeastRange) shift();
    }
    return value;
  }
  /// Writes the remaining bytes.
  void finish() {
    for (int i = 0; i < 5; ++i) shift();
  }

 private:
  static constexpr std::uint32_t kLeastRange = 1u << 24;

  void shift() {
    if (low_ < 0xff000000u || low_ > 0xffffffffu) {
      const auto carry = static_cast<std::uint8_t>(low_ >> 32);
      for (std::uint8_t first = held_; waiting_ > 0; --waiting_, first = 0xff) {
        out_.push_back(static_cast<char>(static_cast<std::uint8_t>(first + carry)));
      }
      held_ = static_cast<std::uint8_t>(low_ >> 24);
    }
    ++waiting_;
    low_ = (low_ & 0x00ffffffu) << 8;
    range_ <<= 8;
  }

  Bytes& out_;
  std::uint64_t low_ = 0;
  std::uint32_t range_ = 0xffffffffu;
  std::uint8_t held_ = 0;      ///< the last byte that a carry can still change
  std::uint64_t waiting_ = 1;  ///< that byte and the 0xff after it
};

/// Reads 0 past the end of its bytes; `good` detects it.
class RangeDecoder {
 public:
  explicit RangeDecoder(BytesView bytes) : bytes_(bytes) {
    for (int i = 0; i < 5; ++i) shift();
  }
  /// Whether exactly the written bytes have been read.
  bool good() const { return next_ == bytes_.size(); }

  unsigned bit(BitModel& model, unsigned) {
    const std::uint32_t bound = (range_ >> 16) * model.chance();
    const unsigned value = code_ < bound ? 1 : 0;
    code_ -= value != 0 ? 0 : bound;
    range_ = value != 0 ? bound : range_ - bound;
    model.learn(value);
    while (range_ < kLeastRange) {
      range_ <<= 8;
      shift();
    }
    return value;
  }
  std::uint64_t bits(std::uint64_t, int count) {
    std::uint64_t value = 0;
    for (int left = count; left > 0;) {
      const int part = left < 16 ? left : 16;
      left -= part;
      range_ >>= part;
      const std::uint32_t most = (1u << part) - 1, found = code_ / range_;
      const std::uint32_t digit = found < most ? found : most;
      code_ -= digit * range_;
      value = value << part | digit;
      while (range_ < kLeastRange) {
        range_ <<= 8;
        shift();
      }
    }
    return value;
  }

 private:
  static constexpr std::uint32_t kLeastRange = 1u << 24;

  void shift() {
    const std::uint32_t byte = next_ < bytes_.size() ? static_cast<unsigned char>(bytes_[next_]) : 0;
    ++next_;
    code_ = code_ << 8 | byte;
  }

  BytesView bytes_;
  std::size_t next_ = 0;
  std::uint32_t code_ = 0;
  std::uint32_t range_ = 0xffffffffu;
};

/// A symbol of `kBits` bits with adaptive probabilities, coded from its highest bit.
template <int kBits>
class ChoiceModel {
 public:
  template <typename Coder>
  unsigned code(Coder& coder, unsigned value) {
    unsigned node = 1;
    for (int i = kBits - 1; i >= 0; --i) node = node << 1 | coder.bit(models_[node], value >> i & 1);
    return node - (1u << kBits);
  }

 private:
  std::array<BitModel, std::size_t{1} << kBits> models_;
};

/// A prediction error, folded like a signed varint. Its size in bits is coded adaptively; the bits below the
/// highest one, including the sign, are noise and stored directly.
class ResidualModel {
 public:
  static constexpr int kContexts = 13;

  /// `context` (below kContexts) selects the size's model. `size` becomes the number of bits.
  template <typename Coder>
  std::int64_t code(Coder& coder, std::int64_t value, int context, int& size) {
    const std::uint64_t folded =
        (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
    const int bits = static_cast<int>(std::bit_width(folded));
    size = static_cast<int>(sizes_[static_cast<std::size_t>(context)].code(
        coder, static_cast<unsigned>(bits < kLongest ? bits : kLongest)));
    if (size == 0) return 0;
    if (size == kLongest)
      size += static_cast<int>(coder.bits(static_cast<std::uint64_t>(bits - kLongest) & 31, 5));
    const std::uint64_t top = std::uint64_t{1} << (size - 1);
    const std::uint64_t whole = top | coder.bits(folded & (top - 1), size - 1);
    return static_cast<std::int64_t>((whole >> 1) ^ (~(whole & 1) + 1));
  }

 private:
  static constexpr int kLongest = 15;  ///< means this size or more; five more bits give it
  std::array<ChoiceModel<4>, kContexts> sizes_;
};

}  // namespace fulbito
