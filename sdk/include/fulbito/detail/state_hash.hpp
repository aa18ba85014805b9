#pragma once

#include <cstdint>
#include <string_view>

#include "fulbito/values.hpp"

namespace fulbito {

/// Running hash (XXH3-64) of values in a fixed order: field by field, each double by its bits with -0 as +0,
/// never raw struct bytes. Equal hashes mean equal states, bit for bit.
class StateHash {
 public:
  /// Of nothing so far.
  StateHash() = default;
  /// Continues from the value of another hash.
  explicit StateHash(std::uint64_t value) : value_(value) {}
  /// By its bits, -0 as +0.
  void add(double value);
  /// By its eight bytes.
  void add(std::uint64_t value);
  /// By its bytes.
  void add(std::string_view text);
  /// The tick, how many bodies of each kind there are, and all values of each body.
  void add(const WorldState& state);
  /// The hash of all that was added so far, in this order.
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace fulbito
