#include <csignal>
#include <limits>
#include <sys/resource.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

/// Writes `ticks` ticks of the sample to a file of at most `most` bytes. Returns the result of `finish`.
Result<void> recordInto(const std::string& file, int ticks, rlim_t most) {
  test::Told told;
  told.header = test::sampleHeader();
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{most, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  Result<void> finished;
  if (auto writer = RecordingWriter::create(file, told.header); !writer) {
    finished = tl::unexpected<Error>(writer.error());
  } else {
    test::Teller teller(told, std::move(*writer));
    teller.tell(ticks, false);
    finished = teller.finish(ticks);
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, SIG_DFL);
  return finished;
}

}  // namespace

TEST_CASE("a full disk leaves whole chunks of a new recording, or nothing", "[unit]") {
  const test::ScratchFolder folder;
  const std::string file = (folder.path() / "a.fbr").string();
  REQUIRE(recordInto(file, 100, RLIM_INFINITY));
  const auto size = fs::file_size(file);
  fs::remove(file);
  for (const std::uintmax_t most : {std::uintmax_t{0}, std::uintmax_t{50}, size / 4, size / 2, size - 1}) {
    INFO(most << " of " << size);
    const auto recorded = recordInto(file, 100, most);
    REQUIRE_FALSE(recorded);
    CHECK(recorded.error().code == ErrorCode::kIo);
    if (fs::exists(file)) {
      const auto cut = RecordingReader::open(file);
      REQUIRE(cut);
      CHECK(cut->ticks() > 0);
      fs::remove(file);
    }
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("a full disk keeps the older recording of that name", "[unit]") {
  const test::ScratchFolder folder;
  const std::string file = (folder.path() / "a.fbr").string();
  REQUIRE(recordInto(file, 100, RLIM_INFINITY));
  const auto size = fs::file_size(file);
  CHECK_FALSE(recordInto(file, 100, size / 2));
  const auto old = RecordingReader::open(file);
  REQUIRE(old);
  CHECK(old->finished());
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("an event at the first of all ticks is broken, not an overflow", "[unit]") {
  test::Told told;
  told.header = test::sampleHeader();
  test::Teller teller(told);
  teller.tell(1, false);
  RecordedEvent event;
  event.tick = std::numeric_limits<Tick>::min();
  teller.writer().add(event);
  REQUIRE(teller.finish(1));
  const auto reader = RecordingReader::parse(told.bytes, "a.fbr");
  REQUIRE(reader);
  CHECK_FALSE(reader->chunk(0));
}

}  // namespace fulbito
