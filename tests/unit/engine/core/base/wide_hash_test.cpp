#include "engine/core/base/wide_hash.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("the wide hash is XXH3-128", "[unit]") {
  // The hash of no bytes, from the reference implementation's documentation.
  CHECK(hexText(wideHash("")) == "99aa06d3014798d86001c324468d497f");
  CHECK(hexText({1, 0xf}) == "0000000000000001000000000000000f");
}

TEST_CASE("a running wide hash takes bytes in any pieces, and texts with their length", "[unit]") {
  WideHash pieces, texts, others;
  pieces.addBytes("ab");
  pieces.addBytes("c");
  CHECK(pieces.value() == wideHash("abc"));
  texts.add("ab");
  texts.add("c");
  others.add("a");
  others.add("bc");
  CHECK(texts.value() != others.value());
}

TEST_CASE("the wide hash takes numbers byte by byte, and both zeros as one", "[unit]") {
  WideHash number, zero, negative;
  number.add(std::uint64_t{0x0807060504030201});
  CHECK(number.value() == wideHash("\1\2\3\4\5\6\7\10"));
  zero.add(0.0);
  negative.add(-0.0);
  CHECK(zero.value() == negative.value());
}

}  // namespace fulbito
