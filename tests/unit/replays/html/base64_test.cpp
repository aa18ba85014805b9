#include "replays/html/base64.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("base64 gives the examples of RFC 4648", "[unit]") {
  CHECK(base64Of("").empty());
  CHECK(base64Of("f") == "Zg==");
  CHECK(base64Of("fo") == "Zm8=");
  CHECK(base64Of("foo") == "Zm9v");
  CHECK(base64Of("foob") == "Zm9vYg==");
  CHECK(base64Of("fooba") == "Zm9vYmE=");
  CHECK(base64Of("foobar") == "Zm9vYmFy");
  CHECK(base64Of("\xfb\xff\xfe") == "+//+");
}

TEST_CASE("hexadecimal digits are bytes", "[unit]") {
  CHECK(bytesOfHex("00ff7a") == std::string("\0\xff\x7a", 3));
  CHECK(bytesOfHex("abx1cd") == "\xab");
  CHECK(bytesOfHex("").empty());
}

}  // namespace fulbito
