// Prints a hash of the C library's sinf, cosf and sincosf, which Box2D calls, for every float from 2^-12 to
// 16. Below 2^-12 the results are the argument and 1. The engine keeps angles in this range, because there
// the variants for processors with and without fused multiply-add agree.
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace {

volatile bool opaque = false;  // keeps the compiler from merging sinf and cosf into sincosf

std::uint64_t mixed(std::uint64_t hash, float value) {
  return (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211u;
}

}  // namespace

int main() {
  const auto first = std::bit_cast<std::uint32_t>(0x1p-12f), last = std::bit_cast<std::uint32_t>(16.0f);
  std::uint64_t apart = 1, joined = 1;
  for (std::uint32_t bits = first; bits <= last; ++bits) {
    const float x = std::bit_cast<float>(bits);
    apart = mixed(apart, std::sin(x));
    apart = mixed(apart, std::cos(opaque ? 0.0f : x));
    float s = 0.0f, c = 0.0f;
    ::sincosf(x, &s, &c);
    joined = mixed(mixed(joined, s), c);
  }
  std::printf("sinf-cosf            %016" PRIx64 "\nsincosf              %016" PRIx64 "\n", apart, joined);
  return 0;
}
