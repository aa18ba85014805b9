#include <filesystem>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;
namespace fs = std::filesystem;

TEST_CASE("a foreign file in an experiment's folder stays, and costs no other result", "[cli]") {
  const Sandbox box;
  box.write("bend.txt", "line 0 0 0\narc 150 60 90\n");
  const std::string command = "experiment transport --set path=bend.txt --out out";
  const fs::path out = box.path / "out/transport";
  fs::create_directories(out);
  for (const std::string file : {"results.json", "transport.html"}) {
    box.write("out/transport/" + file, "somebody's notes\n");
    const Output output = box.run(command);
    INFO(file << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.out.empty());  // said before the work
    CHECK(contentOf(out / file) == "somebody's notes\n");
    fs::remove(out / file);
  }
  // Which tables there are depends on the work.
  box.write("out/transport/rod-error.csv", "somebody's notes\n");
  const Output output = box.run(command);
  INFO(output.err);
  CHECK(output.code == 2);
  CHECK(output.err.find("rod-error.csv") != std::string::npos);
  CHECK(contentOf(out / "rod-error.csv") == "somebody's notes\n");
  CHECK(fs::exists(out / "real-rod.csv"));
  CHECK(fs::exists(out / "transport.html"));
}
