#include "engine/core/system/text_file.hpp"

#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {

TEST_CASE("a file is read whole, from a pipe too, or is too large", "[unit]") {
  const test::ScratchFolder folder;
  const std::string content(600000, 'a');
  CHECK(*readTextFile(folder.write("a", content), 1 << 20) == content);
  CHECK(readTextFile(folder.write("b", content), 599999).error().code == ErrorCode::kBadInput);
  const std::string pipe = (folder.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::jthread writer([&] {
    const int descriptor = ::open(pipe.c_str(), O_WRONLY);
    for (const char* part : {"fu", "lbi", "to"}) (void)!::write(descriptor, part, std::string(part).size());
    ::close(descriptor);
  });
  CHECK(*readTextFile(pipe, 100, "fulb") == "fulbito");
}

TEST_CASE("a writer of a pipe may come later and take its time; no writer is an error, not a hang",
          "[unit]") {
  const test::ScratchFolder folder;
  const std::string pipe = (folder.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  {
    std::jthread writer([&] {
      ::poll(nullptr, 0, 120);
      const int descriptor = ::open(pipe.c_str(), O_WRONLY);
      ::poll(nullptr, 0, 120);
      (void)!::write(descriptor, "late", 4);
      ::close(descriptor);
    });
    CHECK(*readTextFile(pipe, 100) == "late");
  }
  const auto found = readFoundFile(pipe, 100);
  REQUIRE_FALSE(found);
  CHECK(found.error().code == ErrorCode::kIo);
  CHECK(found.error().message.find("not a regular file") != std::string::npos);
  CHECK_FALSE(readFoundFile("/dev/null", 100));
  CHECK_FALSE(readFoundFile(folder.path().string(), 100));
  CHECK(*readFoundFile(folder.write("plain", "text"), 100) == "text");
}

TEST_CASE("what does not begin as it must is not read on", "[unit]") {
  const auto start = readTextFile("/dev/zero", std::size_t{1} << 40, "magic");
  REQUIRE(start);
  CHECK(start->size() == 5);
}

}  // namespace fulbito
