#include <string>

#include "engine/core/math/random.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

const std::string kSample =
    "[layout]\nname = \"a\"\nfield = \"vsss-3v3\"\n[start]\nposition = [-0.5, 0]\nheading_deg = 90.5\n"
    "[goal]\nposition = [0.5, 1e-1]\nheading = 0.25\n[[obstacle]]\nshape = \"box\"\nposition = [0, 0.1]\n"
    "[[obstacle]]\nmotion = \"path\"\npath = [[0, 0], [0.3, 0.2]] # to and fro\nspeed = 0.4\n";

// Whatever the text, the outcome is a valid layout or an error that names the file.
void checkOutcome(const std::string& text) {
  const auto layout = parseLayout(text, "f.toml");
  const bool sound =
      layout ? validate(*layout).has_value() && parseLayout(toToml(*layout), "g").has_value()
             : layout.error().code == ErrorCode::kBadInput && layout.error().message.starts_with("f.toml:");
  if (sound) return;
  CAPTURE(text, layout ? "accepted" : layout.error().message);
  CHECK(sound);
}

}  // namespace

TEST_CASE("every beginning of a layout file gives a layout or an error", "[unit]") {
  REQUIRE(parseLayout(kSample, "f.toml"));
  for (std::size_t length = 0; length <= kSample.size(); ++length) checkOutcome(kSample.substr(0, length));
}

TEST_CASE("a layout file with one wrong byte gives a layout or an error", "[unit]") {
  for (std::size_t at = 0; at < kSample.size(); ++at) {
    std::string text = kSample;
    for (int byte = 0; byte < 256; ++byte) {
      text[at] = static_cast<char>(byte);
      checkOutcome(text);
    }
    text = kSample;
    checkOutcome(text.erase(at, 1));
  }
}

TEST_CASE("a layout file of shuffled pieces gives a layout or an error", "[unit]") {
  Rng rng(3, test::kTestStream);
  const auto below = [&rng](std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(rng.uniform(0.0, static_cast<double>(n))));
  };
  for (int round = 0; round < 3000; ++round) {
    std::string text = kSample;
    for (int change = 0; change < 4; ++change) {
      const std::size_t from = below(text.size()), to = below(text.size());
      const std::string piece = text.substr(from, 1 + below(30));
      text.insert(to, piece);
    }
    checkOutcome(text);
  }
}

}  // namespace fulbito
