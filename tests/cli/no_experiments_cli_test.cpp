#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("a program built without experiments has no command for them", "[cli]") {
  const Sandbox box;
  CHECK_FALSE(contains(box.works("--help").out, "experiment"));
  for (const char* command : {"experiment list", "experiment all", "experiment --help"}) {
    box.fails(command, 2, "experiment");
  }
}
