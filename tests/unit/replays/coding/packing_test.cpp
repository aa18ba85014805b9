#include "replays/coding/packing.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("packed bytes unpack to what they were, and to nothing where some are missing or more", "[unit]") {
  Rng rng(1, test::kTestStream, 0);
  for (const std::size_t size : {0, 1, 1000, 200000}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(rng.uniform(0.0, 20.0));
    const Packer packer(Packer::kFast);
    Bytes packed;
    packer.pack(bytes, packed);
    CHECK(unpacked(packed, size) == bytes);
    if (size > 1000) CHECK(packed.size() < size);
    CHECK_FALSE(unpacked(packed + "x", size));
    CHECK_FALSE(unpacked(packed.substr(0, packed.size() - 1), size));
    if (size > 0) CHECK_FALSE(unpacked(packed, size - 1));
  }
}

TEST_CASE("CRC-32 is the usual one", "[unit]") {
  CHECK(crc32Of("123456789") == 0xcbf43926u);
  CHECK(crc32Of("") == 0u);
}

}  // namespace fulbito
