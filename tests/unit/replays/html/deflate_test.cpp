#include "replays/html/deflate.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/replays/html/inflate.hpp"

namespace fulbito {

TEST_CASE("deflated bytes inflate to what they were", "[unit]") {
  Rng rng(1, test::kTestStream, 0);
  for (const std::size_t size : {0, 1, 1000, 200000}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(rng.uniform(0.0, 20.0));
    const std::string packed = deflated(bytes);
    CHECK(test::inflated(packed, size) == bytes);
    if (size > 1000) CHECK(packed.size() < size);
  }
}

TEST_CASE("CRC-32 is the usual one", "[unit]") {
  CHECK(crc32Of("123456789") == 0xcbf43926u);
  CHECK(crc32Of("") == 0u);
}

}  // namespace fulbito
