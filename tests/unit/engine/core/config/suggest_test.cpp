#include "engine/core/config/suggest.hpp"

#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {
const std::vector<std::string> kWords{"vsss", "firasim", "jung-lee-2015"};
}

TEST_CASE("a misspelt word gets the nearest candidate", "[unit]") {
  CHECK(suggestion("vss", kWords) == " Did you mean 'vsss'?");
  CHECK(suggestion("firaism", kWords) == " Did you mean 'firasim'?");
  CHECK(suggestion("junglee2015", kWords) == " Did you mean 'jung-lee-2015'?");
}

TEST_CASE("capitals do not count and a beginning is near", "[unit]") {
  CHECK(suggestion("VSSS", kWords) == " Did you mean 'vsss'?");
  CHECK(suggestion("ju", kWords) == " Did you mean 'jung-lee-2015'?");
}

TEST_CASE("a word that is near to nothing gets no suggestion", "[unit]") {
  CHECK(suggestion("xyz", kWords).empty());
  CHECK(suggestion("", kWords).empty());
  CHECK(suggestion("vsss", {}).empty());
  CHECK(suggestion(std::string(1000000, 'v'), kWords).empty());
}

}  // namespace fulbito
