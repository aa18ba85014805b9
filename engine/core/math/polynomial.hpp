#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace fulbito::math {

/// The polynomial with coefficients `c`, lowest power first, at z, by Estrin's scheme: pairs are independent,
/// so the CPU overlaps them. The number of coefficients fixes the order of operations.
template <std::size_t N>
inline double polynomial(const std::array<double, N>& c, double z) {
  if constexpr (N == 1) {
    return c[0];
  } else {
    const auto pair = [&]<std::size_t I>() {
      if constexpr (2 * I + 1 < N) {
        return c[2 * I] + z * c[2 * I + 1];
      } else {
        return c[2 * I];
      }
    };
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return polynomial(std::array<double, (N + 1) / 2>{pair.template operator()<I>()...}, z * z);
    }(std::make_index_sequence<(N + 1) / 2>{});
  }
}

}  // namespace fulbito::math
