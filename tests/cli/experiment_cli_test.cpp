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

TEST_CASE("a foreign file in an experiment's folder stays, and costs no other result", "[cli]") {
  const Sandbox box;
  const std::string command = "experiment localization --set rooms=1 --set fields=1 --out out";
  const fs::path out = box.path / "out/localization";
  fs::create_directories(out);
  for (const std::string file : {"results.json", "localization.html"}) {
    box.write("out/localization/" + file, "somebody's notes\n");
    const Output output = box.run(command);
    INFO(file << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.out.empty());  // refused before the work starts
    CHECK(contentOf(out / file) == "somebody's notes\n");
    fs::remove(out / file);
  }
  // Only the work decides which tables there are.
  box.write("out/localization/schemes.csv", "somebody's notes\n");
  box.ends(command, 2, "schemes.csv");
  CHECK(contentOf(out / "schemes.csv") == "somebody's notes\n");
  CHECK(fs::exists(out / "rooms.csv"));
  CHECK(fs::exists(out / "localization.html"));
}
