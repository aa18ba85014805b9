#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("experiment list names all four with their settings", "[cli]") {
  const Sandbox box;
  const Output output = box.run("experiment list");
  CHECK(output.code == 0);
  for (const char* name : {"capture", "hybrid", "localization", "transport", "--set step="}) {
    CHECK(contains(output.out, name));
  }
}

TEST_CASE("experiment refuses unknown names and settings with a suggestion", "[cli]") {
  const Sandbox box;
  box.fails("experiment captur", 2, "Did you mean 'capture'?");
  box.fails("experiment transport --set stpe=0.1", 2, "Did you mean 'step'?");
  CHECK(box.run("experiment transport --set step").code == 2);
  CHECK(box.run("experiment all --set step=0.1").code == 2);
  CHECK(box.run("experiment transport --set step=never").code == 2);
  CHECK(box.run("experiment transport --set path=no-such-file").code != 0);
}
