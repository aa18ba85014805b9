// The running hash of simulation states, for golden tests and recordings.
#pragma once

#include <cstdint>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Running hash (XXH3-64) of values in a fixed order: field by field, each double by its bits with -0 as +0,
/// never raw struct bytes. Equal hashes mean equal states, bit for bit.
class StateHash {
 public:
  /// The hash of no values.
  StateHash() = default;
  /// Continues from the value of another hash.
  explicit StateHash(std::uint64_t value) : value_(value) {}
  /// Adds the bits of a double, -0 as +0.
  void add(double value);
  /// Adds eight bytes.
  void add(std::uint64_t value);
  /// Adds the bytes of a text.
  void add(std::string_view text);
  /// Adds the tick, the number of bodies of each kind, and all values of each body.
  void add(const WorldState& state);
  /// The hash of all values so far, in order.
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;  ///< the hash so far
};

}  // namespace fulbito
