#include "replays/coding/range_coder.hpp"

#include <limits>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr int kCount = 20000;

/// What is written and read in turn, from a seed.
struct Script {
  Rng rng{5, test::kTestStream, 0};
  unsigned rare() { return rng.uniform() < 0.02 ? 1 : 0; }
  unsigned even() { return rng.bits32() & 1; }
  std::uint64_t many() {
    return (std::uint64_t{rng.bits32()} << 32 | rng.bits32()) & ((std::uint64_t{1} << 40) - 1);
  }
};

}  // namespace

TEST_CASE("bits come back from the range coder, and cost what they surprise", "[unit]") {
  Bytes bytes;
  RangeEncoder encoder(bytes);
  BitModel rare, even;
  Script script;
  for (int i = 0; i < kCount; ++i) {
    encoder.bit(rare, script.rare());
    encoder.bit(even, script.even());
    encoder.bits(script.many(), 40);
  }
  encoder.finish();
  // 0.141 bits, 1 bit and 40 bits each; learning costs a little.
  CHECK(8.0 * static_cast<double>(bytes.size()) / kCount == Approx(41.16).margin(0.08));

  RangeDecoder decoder(bytes);
  BitModel rare_read, even_read;
  Script again;
  for (int i = 0; i < kCount; ++i) {
    REQUIRE(decoder.bit(rare_read, 0) == again.rare());
    REQUIRE(decoder.bit(even_read, 0) == again.even());
    REQUIRE(decoder.bits(0, 40) == again.many());
  }
  CHECK(decoder.good());
}

TEST_CASE("a carry runs through any number of full bytes", "[unit]") {
  // Improbable ones among probable ones drive the low end up to the next byte again and again.
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Bytes bytes;
    RangeEncoder encoder(bytes);
    BitModel model;
    Rng rng(seed, test::kTestStream, 1);
    std::vector<unsigned> bits;
    for (int i = 0; i < 400; ++i) bits.push_back(rng.uniform() < 0.01 ? 1 : 0);
    for (const unsigned bit : bits) encoder.bit(model, bit);
    encoder.finish();
    RangeDecoder decoder(bytes);
    BitModel read;
    for (const unsigned bit : bits) REQUIRE(decoder.bit(read, 0) == bit);
    REQUIRE(decoder.good());
  }
}

TEST_CASE("more or fewer bytes than were written are noticed", "[unit]") {
  Bytes bytes;
  RangeEncoder encoder(bytes);
  BitModel model;
  for (int i = 0; i < 100; ++i) encoder.bit(model, static_cast<unsigned>(i) & 1);
  encoder.finish();
  const auto good = [](const Bytes& from) {
    RangeDecoder decoder(from);
    BitModel read;
    for (int i = 0; i < 100; ++i) decoder.bit(read, 0);
    return decoder.good();
  };
  CHECK(good(bytes));
  CHECK_FALSE(good(bytes + '\0'));
  CHECK_FALSE(good(bytes.substr(0, bytes.size() - 1)));
  CHECK_FALSE(good(""));
}

TEST_CASE("residuals of any size come back", "[unit]") {
  std::vector<std::int64_t> values{0, -1, 1, 2, -2, 63, -64, 16383, -16384, 16384, 1000000, -1000000};
  for (int shift = 0; shift < 44; ++shift) {
    values.push_back(std::int64_t{1} << shift);
    values.push_back(-(std::int64_t{1} << shift));
  }
  Bytes bytes;
  RangeEncoder encoder(bytes);
  ResidualModel model;
  int size = 0;
  for (const std::int64_t value : values) {
    encoder.bits(0, 3);
    model.code(encoder, value, 2, size);
  }
  encoder.finish();
  RangeDecoder decoder(bytes);
  ResidualModel read;
  for (const std::int64_t value : values) {
    decoder.bits(0, 3);
    REQUIRE(read.code(decoder, 0, 2, size) == value);
  }
  CHECK(decoder.good());
}

}  // namespace fulbito
