#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("sprt says by its exit code whether a team passes, fails or is not known", "[cli]") {
  const Sandbox box;
  CHECK(box.run("sprt chaser idle --half-seconds 15").code == 0);
  CHECK(box.run("sprt idle chaser --half-seconds 15").code == 1);
  const Output unknown = box.run("sprt chaser chaser --half-seconds 3 --pairs 2");
  CHECK(unknown.code == 6);
  CHECK(contains(unknown.out, "inconclusive"));
}

TEST_CASE("sprt refuses bounds and teams that make no test", "[cli]") {
  const Sandbox box;
  for (const std::string command :
       {"sprt chaser idle --bounds 5,1", "sprt chaser idle --bounds 0,900", "sprt chaser idle --alpha 0",
        "sprt chaser idle --beta nan", "sprt chaser idle --pairs 0", "sprt chaser", "sprt chaser nobody"}) {
    box.fails(command, 2);
  }
}
