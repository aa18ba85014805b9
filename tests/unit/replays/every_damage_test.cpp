#include <fstream>

#include "fulbito/recording.hpp"
#include "replays/recording_salvage.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

/// Only one in so many cases also tests what can be salvaged, which takes long.
constexpr std::size_t kSalvageEvery = 97;

std::string golden() {
  std::ifstream in(FULBITO_GOLDEN_RECORDINGS "/chaser-idle.fbr", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether a reader notices the damage. What it salvages must be readable or an error.
bool noticed(const std::string& bytes, bool also_salvage) {
  const auto reader = RecordingReader::parse(bytes, "damaged");
  if (also_salvage) {
    const auto saved = salvage(bytes, "damaged");
    if (saved && saved->whole) return false;
  }
  return !reader || !reader->finished();
}

/// Number of tested prefixes and flipped bits, and of those that went unnoticed.
struct Tally {
  std::size_t cases = 0, unnoticed = 0;

  void damage(const std::string& whole) {
    REQUIRE(RecordingReader::parse(whole, "whole")->finished());
    for (std::size_t size = 0; size < whole.size(); ++size) {
      count(noticed(whole.substr(0, size), size % kSalvageEvery == 0));
    }
    std::string bytes = whole;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
      count(noticed(bytes, bit % kSalvageEvery == 0));
      bytes[bit / 8] = whole[bit / 8];
    }
  }

 private:
  void count(bool seen) {
    ++cases;
    unnoticed += seen ? 0 : 1;
  }
};

}  // namespace

TEST_CASE("every prefix and every flipped bit of half a million is noticed", "[soak]") {
  Tally tally;
  tally.damage(golden());
  RecordingHeader recipe = test::sampleHeader(RecordingLevel::kRecipe);
  recipe.command_step = 0.0;
  for (const int ticks : {220, 301, 900}) tally.damage(test::sample(ticks).bytes);
  tally.damage(test::sample(200, true, recipe).bytes);
  CHECK(tally.cases > 500000);
  CHECK(tally.unnoticed == 0);
}

}  // namespace fulbito
