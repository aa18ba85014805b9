#include "apps/new_file.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace fulbito::app {

Result<void> mayWrite(const std::string& file, bool force) {
  if (file == "-") return fail(ErrorCode::kUsage, "'-': a recording goes to a file, not to stdout");
  if (auto there = checkPlaceOf(file); !there) return there;
  std::error_code error;
  if (force || !std::filesystem::exists(file, error)) return {};
  return fail(ErrorCode::kUsage, fmt::format("'{}' exists; give --force to replace it", file));
}

}  // namespace fulbito::app
