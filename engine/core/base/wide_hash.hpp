#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace fulbito {

/// A hash of 128 bits.
using WideHashValue = std::array<std::uint64_t, 2>;

/// 32 hexadecimal digits.
std::string hexText(const WideHashValue& value);

/// The hash of these bytes, in one go.
WideHashValue wideHash(std::string_view bytes);

/// Running hash (XXH3-128) of values in a fixed order. It detects accidental differences: among a million
/// contents, any two have the same hash with a probability of 1e-27. It does not resist an attack.
class WideHash {
 public:
  WideHash();
  ~WideHash();
  WideHash(const WideHash&) = delete;
  WideHash& operator=(const WideHash&) = delete;

  /// Adds bytes without their number: a text added in parts gives the same hash as the whole text.
  void addBytes(std::string_view bytes);
  /// Adds a text with its length, so that neighbours cannot trade characters.
  void add(std::string_view text);
  /// Adds eight bytes, in the same order on all machines.
  void add(std::uint64_t value);
  /// Adds the bits of a double, -0 as +0.
  void add(double value);
  /// The hash of all values so far.
  WideHashValue value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fulbito
