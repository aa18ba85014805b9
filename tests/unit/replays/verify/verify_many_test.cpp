#include "replays/verify/verify_many.hpp"

#include <fstream>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("recordings of folders come by name, files as they are", "[unit]") {
  const ScratchFolder folder;
  for (const char* name : {"b.fbr", "a.fbr", "c.txt"}) write(folder.path() / name, "x");
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  const auto files = recordingFiles({path("c.txt"), folder.path().string()});
  REQUIRE(files);
  CHECK(*files == std::vector<std::string>{path("c.txt"), path("a.fbr"), path("b.fbr")});
}

TEST_CASE("many recordings are verified at once, the same for any number of jobs", "[unit]") {
  const ScratchFolder folder;
  std::vector<std::string> files;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    MatchConfig config = shortMatch("chaser", "chaser", 3.0);
    config.seed = seed;
    files.push_back((folder.path() / ("m" + std::to_string(seed) + ".fbr")).string());
    std::string bytes = recorded(config, RecordingLevel::kRecipe);
    if (seed == 2) bytes[bytes.size() / 2] ^= 1;
    write(files.back(), bytes);
  }
  files.push_back((folder.path() / "missing.fbr").string());
  for (const int jobs : {1, 3, 0}) {
    std::size_t heard = 0;
    const auto verified = verifyRecordings(files, jobs, [&](std::size_t done, std::size_t total) {
      heard = done;
      return total == 6;
    });
    REQUIRE(verified);
    CHECK(heard == 6);
    for (std::size_t i = 0; i < files.size(); ++i) {
      INFO(i);
      CHECK((*verified)[i].file == files[i]);
      CHECK((*verified)[i].result.has_value() == (i != 2 && i != 5));
      if ((*verified)[i].result) CHECK((*verified)[i].result->same());
    }
    CHECK((*verified)[2].result.error().code == ErrorCode::kBadInput);
    CHECK((*verified)[5].result.error().code == ErrorCode::kIo);
  }
  const auto stopped = verifyRecordings(files, 1, [](std::size_t, std::size_t) { return false; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}

// The golden recording has other physics: in it bodies overlap, and each wheel is limited separately.
TEST_CASE("a recording of other physics is played again, and found to differ", "[unit]") {
  const auto files = recordingFiles({FULBITO_GOLDEN_RECORDINGS});
  REQUIRE(files);
  REQUIRE(files->size() == 1);
  const auto verified = verifyRecordings(*files, 1, nullptr);
  REQUIRE(verified);
  const auto& result = verified->front().result;
  REQUIRE(result);
  CHECK_FALSE(result->same());
  CHECK(result->final_hash != 0xbd119ad0e1f45b69u);
}

}  // namespace fulbito
