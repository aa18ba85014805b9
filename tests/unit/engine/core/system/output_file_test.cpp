#include "engine/core/system/output_file.hpp"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/unfinished_work.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() / ("fulbito-output-" + std::to_string(::getpid()));
  TemporaryFolder() { fs::create_directories(path); }
  ~TemporaryFolder() { fs::remove_all(path); }
};

std::string contentOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Limits the length of this process's files during its life.
struct FileSizeLimit {
  rlimit before{};
  explicit FileSizeLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before);
    rlimit limit = before;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before);
    ::signal(SIGXFSZ, SIG_DFL);
  }
};

}  // namespace

TEST_CASE("a file is written whole and replaces the old one", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "a.txt";
  REQUIRE(writeFile(file, "one"));
  REQUIRE(writeFile(file, "two"));
  CHECK(contentOf(file) == "two");
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("a file that cannot be written is named and leaves nothing behind", "[unit]") {
  const TemporaryFolder folder;
  const auto missing = writeFile(folder.path / "no" / "a.txt", "x");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::kIo);
  CHECK(missing.error().message.find("a.txt': there is no folder '") != std::string::npos);
  REQUIRE(writeFile(folder.path / "file", "x"));
  const auto below = writeFile(folder.path / "file" / "a.txt", "x");
  REQUIRE_FALSE(below);
  CHECK(below.error().message.find("file' is not a folder") != std::string::npos);
  fs::remove(folder.path / "file");
  fs::create_directories(folder.path / "b.txt" / "inside");
  CHECK_FALSE(writeFile(folder.path / "b.txt", "x"));
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("a device is written to, not replaced", "[unit]") {
  CHECK(writeFile("/dev/null", "x"));
  CHECK(std::filesystem::is_character_file("/dev/null"));
  const auto full = writeFile("/dev/full", "x");
  REQUIRE_FALSE(full);
  CHECK(full.error().code == ErrorCode::kIo);
  CHECK(std::filesystem::is_character_file("/dev/full"));
}

TEST_CASE("a node of one's own stays a node: pipe, and as root device", "[unit]") {
  const TemporaryFolder folder;
  const std::string pipe = folder.path / "pipe", null = folder.path / "null";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string read;
  std::jthread reader([&] { read = contentOf(pipe); });
  CHECK(writeFile(pipe, "through"));
  reader.join();
  CHECK(read == "through");
  CHECK(fs::is_fifo(pipe));
  if (::geteuid() != 0 || ::mknod(null.c_str(), S_IFCHR | 0600, 0x103) != 0) return;
  // Some mounts (nodev) do not let it be opened; it must exist in any case.
  (void)writeFile(null, "gone");
  CHECK(fs::is_character_file(null));
}

TEST_CASE("files that have the name of the temporary one are left alone, links are not followed", "[unit]") {
  const TemporaryFolder folder;
  const std::string victim = folder.path / "victim", file = folder.path / "x.png";
  REQUIRE(writeFile(victim, "precious"));
  for (int i = 0; i < 200; ++i) {
    fs::create_symlink(victim, fmt::format("{}.{}-{}.tmp", file, ::getpid(), i));
  }
  fs::create_symlink(victim, file + ".part");
  REQUIRE(writeFile(file, "picture"));
  CHECK(contentOf(victim) == "precious");
  CHECK(contentOf(file) == "picture");
  CHECK_FALSE(fs::is_symlink(file));
}

TEST_CASE("a link to a file stays a link, and the file keeps its rights", "[unit]") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "own", link = folder.path / "link";
  REQUIRE(writeFile(file, "one"));
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file, link);
  REQUIRE(writeFile(link, "two"));
  CHECK(fs::is_symlink(link));
  CHECK(contentOf(file) == "two");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a file that grows can be read at once; another one of its name is kept until it is whole",
          "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "lines";
  auto out = OutputFile::grow(file, false);
  REQUIRE(out);
  REQUIRE(out->write("one\n"));
  CHECK(contentOf(file) == "one\n");
  const auto second = OutputFile::grow(file, false);
  REQUIRE_FALSE(second);
  CHECK(second.error().code == ErrorCode::kUsage);
  REQUIRE(out->commit());
  {
    auto dropped = OutputFile::grow(file, true);
    REQUIRE(dropped);
    REQUIRE(dropped->write("half"));
  }
  CHECK(contentOf(file) == "one\n");
  auto replaced = OutputFile::grow(file, true);
  REQUIRE(replaced);
  REQUIRE(replaced->write("two\n"));
  CHECK(contentOf(file) == "one\n");
  REQUIRE(replaced->commit());
  CHECK(contentOf(file) == "two\n");
  CHECK(filesIn(folder.path) == 1);
}

TEST_CASE("a file too large for the system is an error that leaves nothing, or whole lines", "[unit]") {
  const TemporaryFolder folder;
  const std::string whole = folder.path / "whole", lines = folder.path / "lines";
  auto growing = OutputFile::grow(lines, false);
  REQUIRE(growing);
  {
    const FileSizeLimit limit(1000);
    const auto written = writeFile(whole, std::string(5000, 'x'));
    REQUIRE_FALSE(written);
    CHECK(written.error().code == ErrorCode::kIo);
    REQUIRE(growing->write(std::string(600, 'a')));
    CHECK_FALSE(growing->write(std::string(600, 'b')));
    CHECK_FALSE(growing->commit());
  }
  CHECK_FALSE(fs::exists(whole));
  CHECK(contentOf(lines) == std::string(600, 'a'));
  CHECK(filesIn(folder.path) == 1);
}

TEST_CASE("who ends in the middle of a file can remove what there is of it", "[unit]") {
  const TemporaryFolder folder;
  const TemporaryName listed(folder.path / "half");
  std::ofstream(folder.path / "half") << "half";
  CHECK(filesIn(folder.path) == 1);
  abandonUnfinishedWork();
  CHECK(filesIn(folder.path) == 0);
}

TEST_CASE("who is killed in the middle of a file leaves nothing, and the old one whole", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "film", fresh = folder.path / "fresh";
  REQUIRE(writeFile(file, "old"));
  const int probe = ::open(folder.path.c_str(), O_TMPFILE | O_RDWR, 0600);
  if (probe < 0) return;  // the file system has no files without a name
  ::close(probe);
  const pid_t child = ::fork();
  if (child == 0) {
    auto first = OutputFile::create(file), second = OutputFile::create(fresh);
    const bool written = first && second && first->write("half") && second->write("half");
    if (written) ::kill(::getpid(), SIGKILL);
    ::_exit(1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(filesIn(folder.path) == 1);
  CHECK(contentOf(file) == "old");
}

TEST_CASE("another program can write a file before it has its name", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "film";
  auto out = OutputFile::create(file);
  REQUIRE(out);
  std::ofstream(out->place(), std::ios::trunc) << "frames";
  CHECK_FALSE(fs::exists(file));
  REQUIRE(out->commit());
  CHECK(contentOf(file) == "frames");
}

TEST_CASE("a rule decides what is replaced, and sees how the new file begins", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "a", other = folder.path / "b";
  REQUIRE(writeFile(file, "one"));
  std::string seen;
  setReplacementRule([&](const std::string& name, std::string_view head) -> Result<void> {
    seen = name + " " + std::string(head);
    if (name == file) return fail(ErrorCode::kUsage, "kept");
    return {};
  });
  const auto refused = writeFile(file, "two");
  CHECK(writeFile(other, "three"));
  setReplacementRule({});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message == "kept");
  CHECK(contentOf(file) == "one");
  CHECK(seen == other + " three");
  CHECK(filesIn(folder.path) == 2);
}

TEST_CASE("a probe of a folder harms no file in it", "[unit]") {
  const TemporaryFolder folder;
  REQUIRE(writeFile(folder.path / ".fulbito-probe", "mine"));
  REQUIRE(prepareFolder(folder.path));
  CHECK(contentOf(folder.path / ".fulbito-probe") == "mine");
  CHECK(filesIn(folder.path) == 1);
}

TEST_CASE("an output folder is made, or the error names it", "[unit]") {
  const TemporaryFolder folder;
  CHECK(prepareFolder(folder.path / "deep" / "er"));
  CHECK(fs::is_empty(folder.path / "deep" / "er"));
  REQUIRE(writeFile(folder.path / "file", "x"));
  const auto blocked = prepareFolder(folder.path / "file" / "below");
  REQUIRE_FALSE(blocked);
  CHECK(blocked.error().code == ErrorCode::kIo);
  CHECK(blocked.error().message.find("file/below") != std::string::npos);
  CHECK_FALSE(prepareFolder("/proc/fulbito"));
}

}  // namespace fulbito
