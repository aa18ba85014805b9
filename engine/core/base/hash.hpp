#pragma once

#include <cstdint>
#include <string_view>

#include "engine/core/base/values.hpp"

namespace fulbito {

/// Running hash (XXH3-64) of values in a fixed order: field by field, each double by its bits with -0 as +0,
/// never raw struct bytes. Equal hashes mean equal states, bit for bit.
class StateHash {
 public:
  StateHash() = default;
  /// Continues from the value of another hash.
  explicit StateHash(std::uint64_t value) : value_(value) {}
  void add(double value);
  void add(std::uint64_t value);
  void add(std::string_view text);
  void add(const WorldState& state);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace fulbito
