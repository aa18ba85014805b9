#include "apps/common/output_names.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDash = "-";

/// Whether `file` is a device, pipe or socket: writing to it replaces nothing.
bool isStream(const std::string& file) {
  std::error_code error;
  const fs::file_type kind = fs::status(file, error).type();
  return kind == fs::file_type::character || kind == fs::file_type::fifo || kind == fs::file_type::block ||
         kind == fs::file_type::socket;
}

/// The path with all links of its folder resolved.
fs::path wholeName(const std::string& file) {
  std::error_code error;
  const fs::path path = fs::absolute(file, error);
  return fs::weakly_canonical(path.parent_path(), error) / path.filename();
}

tl::unexpected<Error> usage(std::string message) { return fail(ErrorCode::kUsage, std::move(message)); }

Result<void> apart(const NamedFile& output, const NamedFile& other, const char* use) {
  if (output.file.empty() || other.file.empty()) return {};
  if (output.file == kDash && other.file == kDash) {
    return usage(
        fmt::format("{} and {} both write to stdout; give one of them a file", output.flag, other.flag));
  }
  if (!sameFile(output.file, other.file)) return {};
  return usage(
      fmt::format("{}: '{}' is {} {}; choose another name", output.flag, output.file, use, other.flag));
}

}  // namespace

bool sameFile(const std::string& a, const std::string& b) {
  if (a == kDash || b == kDash || isStream(a) || isStream(b)) return false;
  std::error_code error;
  return fs::equivalent(a, b, error) || wholeName(a) == wholeName(b);
}

Result<void> mayWrite(const NamedFile& output, bool force) {
  if (output.file.empty()) return {};
  if (output.file == kDash) {
    if (output.dash == Dash::kStdout) return {};
    return usage(fmt::format("{}: '-': the output must go to a file, not to stdout", output.flag));
  }
  if (isStream(output.file)) return {};
  if (auto there = checkOutputPath(output.file); !there) return there;
  std::error_code error;
  if (force || !fs::exists(output.file, error)) return {};
  return usage(fmt::format("{}: '{}' exists; use --force to replace it", output.flag, output.file));
}

Result<void> mayWriteAll(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs,
                         bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const NamedFile& input : inputs) {
      if (auto other = apart(outputs[i], input, "also the input of"); !other) return other;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (auto other = apart(outputs[i], outputs[j], "also the output of"); !other) return other;
    }
    if (auto may = mayWrite(outputs[i], force); !may) return may;
  }
  return {};
}

}  // namespace fulbito::app
