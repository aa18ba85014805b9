#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

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
  const Output name = box.run("experiment captur");
  CHECK(name.code == 2);
  CHECK(contains(name.err, "Did you mean 'capture'?"));
  const Output setting = box.run("experiment transport --set stpe=0.1");
  CHECK(setting.code == 2);
  CHECK(contains(setting.err, "Did you mean 'step'?"));
  CHECK(box.run("experiment transport --set step").code == 2);
  CHECK(box.run("experiment all --set step=0.1").code == 2);
  CHECK(box.run("experiment transport --set step=never").code == 2);
  CHECK(box.run("experiment transport --set path=no-such-file").code != 0);
}

TEST_CASE("experiment writes the same files for any number of jobs", "[cli]") {
  const Sandbox box;
  box.write("bend.txt", "line 0 0 0\narc 150 60 90\n");
  const auto run = [&](const std::string& jobs, const std::string& folder) {
    return box.run("experiment transport --set path=bend.txt --json --jobs " + jobs + " --out " + folder);
  };
  const Output alone = run("1", "alone"), together = run("2", "together");
  REQUIRE(alone.code == 0);
  CHECK(alone.out == together.out);
  CHECK(Json::parse(alone.out)["experiment"] == "transport");
  CHECK(std::filesystem::exists(box.path / "alone/transport/real-rod.gif"));
  CHECK(std::system(
            ("diff -r " + (box.path / "alone").string() + " " + (box.path / "together").string()).c_str()) ==
        0);
}
