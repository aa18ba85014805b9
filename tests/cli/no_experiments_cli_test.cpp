#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("a build without experiments says so", "[cli]") {
  const Sandbox box;
  for (const char* command : {"experiment list", "experiment all", "experiment transport"}) {
    const Output output = box.run(command);
    INFO(command);
    CHECK(output.code == 2);
    CHECK(output.out.empty());
    CHECK(output.err.find("-DFULBITO_EXPERIMENTS=ON") != std::string::npos);
  }
}
