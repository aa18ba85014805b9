#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

#include <png.h>

#include "tests/support/catch.hpp"
#include "tests/unit/replays/render/samples.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// An empty temporary folder that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "fulbito-png-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { fs::remove_all(path_); }

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
  }

 private:
  fs::path path_;
};

/// Limits the size of files to `bytes`, with errors like those of a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

Canvas colourful() {
  Canvas canvas = *Canvas::create(120, 90, {20, 30, 40});
  canvas.fillCircle({60, 45}, 30, {230, 159, 0});
  canvas.line({3, 5}, {117, 80}, 3.3, {0, 158, 115, 140});
  canvas.text({10, 80}, "PNG", 18, {255, 255, 255});
  return canvas;
}

std::vector<Colour> decoded(const std::string& file, int& width, int& height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, file.c_str()) != 0);
  image.format = PNG_FORMAT_RGBA;
  width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  std::vector<Colour> pixels(image.width * image.height);
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a written picture reads back with the same pixels", "[unit]") {
  const TemporaryFolder folder;
  const Canvas canvas = colourful();
  REQUIRE(canvas.writePng(folder.file("a.png")));
  CHECK(folder.entries() == 1);
  int width = 0, height = 0;
  const std::vector<Colour> pixels = decoded(folder.file("a.png"), width, height);
  REQUIRE(width == canvas.width());
  REQUIRE(height == canvas.height());
  int different = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      different += same(pixels[static_cast<std::size_t>(y * width + x)], canvas.pixel(x, y)) ? 0 : 1;
    }
  }
  CHECK(different == 0);
}

TEST_CASE("the same picture gives the same file", "[unit]") {
  const TemporaryFolder folder;
  REQUIRE(colourful().writePng(folder.file("a.png")));
  REQUIRE(colourful().writePng(folder.file("b.png")));
  CHECK(content(folder.file("a.png")).size() > 100);
  CHECK(content(folder.file("a.png")) == content(folder.file("b.png")));
}

TEST_CASE("a folder that does not exist is an error that names the file", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.file("missing/a.png");
  const auto written = colourful().writePng(file);
  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kIo);
  CHECK(written.error().message == "cannot write '" + file + "': there is no folder '" +
                                       std::filesystem::path(file).parent_path().string() + "'");
  CHECK(folder.entries() == 0);
}

TEST_CASE("a name that is a folder is refused and nothing is left behind", "[unit]") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("a.png"));
  const auto written = colourful().writePng(folder.file("a.png"));
  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kIo);
  CHECK_THAT(written.error().message, Catch::Contains(folder.file("a.png")));
  CHECK(folder.entries() == 1);
}

TEST_CASE("a disk that fills up leaves the older picture and no part of the new one", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.png");
  REQUIRE(Canvas::create(8, 8, {})->writePng(file));
  const std::string before = content(file);
  Result<void> written;
  {
    const FileSizeLimit limit(500);
    written = colourful().writePng(file);
  }
  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kIo);
  CHECK(written.error().message == "cannot write '" + file + "': File too large");
  CHECK(content(file) == before);
  CHECK(folder.entries() == 1);
}

}  // namespace fulbito
