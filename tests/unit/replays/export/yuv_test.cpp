#include "replays/export/yuv.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

struct Yuv {
  int y, u, v;
};

Yuv colourOf(Colour colour) {
  std::string out;
  toYuv420(*Canvas::create(4, 2, colour), out);
  REQUIRE(out.size() == 12);
  const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(out[i])); };
  CHECK(byte(0) == byte(7));
  CHECK(byte(8) == byte(9));
  return {byte(0), byte(8), byte(10)};
}

}  // namespace

TEST_CASE("colours become BT.709's, within one step", "[unit]") {
  const auto near = [](Colour colour, Yuv wanted) {
    const Yuv got = colourOf(colour);
    INFO(got.y << " " << got.u << " " << got.v);
    CHECK(std::abs(got.y - wanted.y) <= 1);
    CHECK(std::abs(got.u - wanted.u) <= 1);
    CHECK(std::abs(got.v - wanted.v) <= 1);
  };
  near({0, 0, 0}, {16, 128, 128});
  near({255, 255, 255}, {235, 128, 128});
  near({128, 128, 128}, {126, 128, 128});
  near({255, 0, 0}, {63, 102, 240});
  near({0, 255, 0}, {173, 42, 26});
  near({0, 0, 255}, {32, 240, 118});
}

}  // namespace fulbito
