#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

/// What a command prints and the files that it writes, without what is measured.
std::string resultsOf(const std::string& command, int jobs) {
  const Sandbox box;
  Json printed = Json::parse(box.works(command + " --json --jobs " + std::to_string(jobs)).out);
  dropMeasured(printed);
  printed.erase("wall_s");
  std::string all = printed.dump();
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(box.path)) {
    // Of the JSON files, one is what was printed, and the others have times.
    if (entry.is_regular_file() && entry.path().extension() != ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    CHECK(fs::file_size(file) > 10);
    all += fs::relative(file, box.path).string() + contentOf(file);
  }
  return all;
}

}  // namespace

TEST_CASE("every command that works in parallel has the same results for any number of jobs", "[cli]") {
  const std::string command = GENERATE(
      as<std::string>(),  //
      "match chaser idle --half-seconds 3 -n 3", "sprt chaser idle --half-seconds 5 --pairs 40",
      "tune classic:strike_speed=0.4 --half-seconds 4 --iterations 3 --pairs 2 --final-pairs 2",
      "tune classic --half-seconds 4 --iterations 3 --pairs 2 --final-pairs 2 --opponent chaser "
      "--starts kick-off,free-ball",
      "drill chaser --drill 3,10 --trials 4", "tournament navigators bezier straight --suite corner -n 6",
      "compare --suite corner --navigators bezier straight --speeds 1.0,2.6 --trials 3 --pictures 1 --out o",
      "compare --map --suite close-range --speeds 1 --radii 0.06,0.1 --widths 0.2 --laws classic "
      "--headings goal --trials 3 --seeds 2 --fresh 1 --out o",
      "experiment localization --set rooms=1 --set fields=1 --out o");
  if (command.starts_with("experiment") && !FULBITO_EXPERIMENTS) return;
  INFO(command);
  CHECK(resultsOf(command, 1) == resultsOf(command, 3));
}
