#include "engine/core/math/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10 as Salmon et al. (SC 2011) define it, independent of the library that Rng uses.
Words philox(Words counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53u} * counter[0],
                        b = std::uint64_t{0xCD9E8D57u} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key = {key[0] + 0x9E3779B9u, key[1] + 0xBB67AE85u};
  }
  return counter;
}

Words fourOf(Rng& rng) {
  Words words;
  for (std::uint32_t& word : words) word = rng.bits32();
  return words;
}

TEST_CASE("the all-zero counter and key give the published Philox words", "[unit]") {
  Rng rng(0, static_cast<Stream>(0));
  CHECK(fourOf(rng) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
}

TEST_CASE("seed is the key; block, stream and index are the counter", "[unit]") {
  // The published vectors first: they check the reference implementation above.
  REQUIRE(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}) ==
          Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  REQUIRE(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
  Rng rng(0x299f31d0a4093822u, Stream::kTuner, 0x0370734413198a2eu);
  for (std::uint32_t block = 0; block < 100; ++block)
    REQUIRE(fourOf(rng) == philox({block, 4, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}));
}

TEST_CASE("first draws of a stream never change", "[unit]") {
  Rng bits(7, Stream::kLayout, 3), numbers(7, Stream::kLayout, 3), normals(7, Stream::kSensorNoise);
  CHECK(bits.bits64() == 0xfa43867a30bcecabu);
  CHECK(numbers.uniform() == 0x1.f4870cf46179dp-1);
  CHECK(numbers.below(1000) == 250);
  CHECK(normals.normal() == 0x1.8f32bce145d1ep-4);
  CHECK(normals.normal(10.0, 0.5) == 0x1.46b77885d4971p+3);
}

TEST_CASE("streams, indices and seeds give different numbers", "[unit]") {
  std::set<std::uint64_t> seen;
  std::size_t count = 0;
  for (std::uint64_t seed : {0ull, 1ull, 1ull << 32, ~0ull}) {
    for (std::uint32_t stream = 1; stream <= 7; ++stream) {
      for (std::uint64_t index : {0ull, 1ull, 1ull << 32}) {
        Rng rng(seed, static_cast<Stream>(stream), index);
        for (int i = 0; i < 100; ++i, ++count) seen.insert(rng.bits64());
      }
    }
  }
  CHECK(seen.size() == count);  // 8400 of 2^64: a repetition by chance has odds below 10^-11
}

TEST_CASE("neighbouring streams and indices are not correlated", "[unit]") {
  constexpr int kDraws = 100000;
  const auto correlation = [](Rng a, Rng b) {
    double sum = 0.0;
    for (int i = 0; i < kDraws; ++i) sum += (a.uniform() - 0.5) * (b.uniform() - 0.5);
    return 12.0 * sum / kDraws;
  };
  const double five_sigma = 5.0 / std::sqrt(kDraws);
  CHECK(std::abs(correlation({1, Stream::kLayout}, {1, Stream::kObstacleMotion})) < five_sigma);
  CHECK(std::abs(correlation({1, Stream::kLayout, 0}, {1, Stream::kLayout, 1})) < five_sigma);
  CHECK(std::abs(correlation({1, Stream::kLayout}, {2, Stream::kLayout})) < five_sigma);
}

TEST_CASE("uniform numbers fill their interval evenly", "[unit]") {
  constexpr int kDraws = 200000, kBins = 20;
  Rng rng(3, test::kTestStream);
  std::array<int, kBins> bins{};
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = rng.uniform();
    REQUIRE(u >= 0.0);
    REQUIRE(u < 1.0);
    sum += u;
    squares += u * u;
    ++bins[static_cast<std::size_t>(u * kBins)];
  }
  const double mean = sum / kDraws;
  CHECK(mean == Approx(0.5).margin(5.0 * std::sqrt(1.0 / 12 / kDraws)));
  CHECK(squares / kDraws - mean * mean == Approx(1.0 / 12).margin(5.0 * std::sqrt(1.0 / 180 / kDraws)));
  double chi_square = 0.0;
  for (int n : bins) chi_square += (n - kDraws / kBins) * (n - kDraws / kBins) / double{kDraws / kBins};
  CHECK(chi_square < 50.8);  // 19 degrees of freedom, odds 10^-4
}

TEST_CASE("a uniform number never reaches the upper end, however narrow the interval", "[unit]") {
  Rng rng(4, test::kTestStream);
  const double high = std::nextafter(1.0, 2.0);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE(rng.uniform(1.0, high) == 1.0);
    const double wide = rng.uniform(-1e308, 1e308);
    REQUIRE(std::isfinite(wide));
    REQUIRE(rng.uniform(2.0, 2.0) == 2.0);
  }
}

TEST_CASE("below gives every number equally often, also where 2^32 is no multiple", "[unit]") {
  CHECK(Rng(5, test::kTestStream).below(0) == 0);
  CHECK(Rng(5, test::kTestStream).below(1) == 0);
  // Without rejection, a third of this range would come up twice as often as the rest.
  constexpr std::uint32_t kRange = 0xC0000000u;
  constexpr int kDraws = 300000;
  Rng rng(5, test::kTestStream);
  std::array<int, 3> thirds{};
  int multiples = 0;
  for (int i = 0; i < kDraws; ++i) {
    const std::uint32_t n = rng.below(kRange);
    REQUIRE(n < kRange);
    ++thirds[n / 0x40000000u];
    if (n % 3 == 0) ++multiples;
  }
  const double five_sigma = 5.0 * std::sqrt(kDraws * 2.0 / 9.0);
  for (int n : thirds) CHECK(n == Approx(kDraws / 3.0).margin(five_sigma));
  CHECK(multiples == Approx(kDraws / 3.0).margin(five_sigma));
}

TEST_CASE("normal numbers have the moments and tails of the normal distribution", "[unit]") {
  constexpr int kDraws = 200000;
  Rng rng(6, test::kTestStream);
  double m1 = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = rng.normal();
    m1 += x, m2 += x * x, m3 += x * x * x, m4 += x * x * x * x;
    if (std::abs(x) > 2.0) ++beyond_two;
  }
  const auto five_sigma = [](double variance) { return 5.0 * std::sqrt(variance / kDraws); };
  CHECK(m1 / kDraws == Approx(0.0).margin(five_sigma(1.0)));
  CHECK(m2 / kDraws == Approx(1.0).margin(five_sigma(2.0)));
  CHECK(m3 / kDraws == Approx(0.0).margin(five_sigma(15.0)));
  CHECK(m4 / kDraws == Approx(3.0).margin(five_sigma(96.0)));
  constexpr double kTail = 0.04550026389635842;  // erfc(sqrt(2))
  CHECK(beyond_two / double{kDraws} == Approx(kTail).margin(five_sigma(kTail * (1.0 - kTail))));
}

TEST_CASE("mean and sigma shift and scale the same draw", "[unit]") {
  Rng plain(8, test::kTestStream), shifted(8, test::kTestStream);
  for (int i = 0; i < 100; ++i) REQUIRE(shifted.normal(3.0, 0.25) == 3.0 + 0.25 * plain.normal());
}

}  // namespace
}  // namespace fulbito
