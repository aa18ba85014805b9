#include "engine/core/text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;  // [bytes] that are read at a time

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

tl::unexpected<Error> cannotRead(const std::string& path, int reason) {
  return fail(ErrorCode::kIo,
              fmt::format("cannot read '{}': {}", path, std::generic_category().message(reason)));
}

}  // namespace

Result<std::string> readTextFile(const std::string& path, std::size_t max_bytes) {
  // A name with a zero byte would silently open another file.
  if (path.empty() || path.find('\0') != std::string::npos) return cannotRead(path, ENOENT);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannotRead(path, EISDIR);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) return cannotRead(path, errno);
  std::string text;
  for (bool more = true; more && text.size() <= max_bytes;) {
    const std::size_t begin = text.size(), room = std::min(kStep, max_bytes + 1 - begin);
    text.resize(begin + room);
    const std::size_t count = std::fread(text.data() + begin, 1, room, file.get());
    text.resize(begin + count);
    more = count == room && std::feof(file.get()) == 0 && std::ferror(file.get()) == 0;
  }
  if (std::ferror(file.get()) != 0) return cannotRead(path, errno);
  if (text.size() > max_bytes) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: larger than {} bytes, the most that is read", path, max_bytes));
  }
  return text;
}

}  // namespace fulbito
