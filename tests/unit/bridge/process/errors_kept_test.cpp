#include "bridge/process/errors_kept.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("of errors the beginning is kept and the rest counted", "[unit]") {
  ErrorsKept kept;
  CHECK(kept.take() == "");
  kept.add("one\n");
  kept.add("two");
  CHECK(kept.take() == "one\ntwo");
  kept.add(std::string(65530, 'x'));
  kept.add("0123456789");
  kept.add("more");
  const std::string text = kept.take();
  CHECK(text.substr(65530) == "012345\n[8 more bytes of standard error]\n");
  CHECK(kept.take() == "");
}

}  // namespace fulbito
