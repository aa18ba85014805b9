#include "apps/common/command_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDash = "-";
constexpr std::array kResultFiles{"plan.json", "tune.json", "matches.jsonl"};
constexpr const char* kRecordings = "recordings";
constexpr std::array kProductEndings{".json", ".csv", ".png", ".gif", ".fbr"};

tl::unexpected<Error> usage(std::string message) { return fail(ErrorCode::kUsage, std::move(message)); }

/// Whether `file` is a device, pipe or socket. Writing to it replaces no file.
bool isStream(const std::string& file) {
  std::error_code error;
  const fs::file_type kind = fs::status(file, error).type();
  return kind == fs::file_type::character || kind == fs::file_type::fifo || kind == fs::file_type::block ||
         kind == fs::file_type::socket;
}

bool exists(const std::string& file) {
  std::error_code error;
  return fs::exists(file, error);
}

/// The path with all links resolved, as far as they exist.
fs::path wholeName(const std::string& file) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  return whole.has_filename() ? whole : whole.parent_path();
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

Result<void> CommandFiles::add(const NamedOutput& output) {
  if (output.file.empty()) return {};
  if (auto good = checkApart(output); !good) return good;
  if (output.file == kDash) {
    if (output.traits.dash == Dash::kRefused) {
      return usage(fmt::format("{}: '-': the output must go to a file, not to stdout", output.flag));
    }
    to_stdout_.push_back(output.flag);
    return {};
  }
  if (isStream(output.file)) return {};
  if (auto good = checkPlace(output); !good) return good;
  const std::string what = fmt::format("{}: '{}'", output.flag, output.file);
  if (auto good = checkKept(what, output.file, {}); !good) return good;
  if (auto good = checkName(output); !good) return good;
  if (auto good = checkExisting(output); !good) return good;
  flag_of_file_[wholeName(output.file).string()] = output.flag;
  return {};
}

/// A file name with the ending of another kind of file is a mistake. Errors: kUsage.
Result<void> CommandFiles::checkName(const NamedOutput& output) const {
  const auto promised = kindOfName(output.file);
  if (!promised || *promised == output.traits.kind) return {};
  const auto other = std::find_if(named_.offered.begin(), named_.offered.end(),
                                  [&](const auto& offered) { return offered.second == *promised; });
  const std::string advice =
      other == named_.offered.end() ? "" : fmt::format("use {} for it, or ", other->first);
  return usage(fmt::format("{}: '{}' is the name of {}, and {} writes {}; {}choose another name", output.flag,
                           output.file, wordsOf(*promised), output.flag, wordsOf(output.traits.kind),
                           advice));
}

Result<void> CommandFiles::checkApart(const NamedOutput& output) const {
  if (output.file == kDash) {
    if (to_stdout_.empty() || to_stdout_.front() == output.flag) return {};
    return usage(fmt::format("{} and {} both write to stdout; give one of them a file", output.flag,
                             to_stdout_.front()));
  }
  const auto other = flag_of_file_.find(wholeName(output.file).string());
  if (other == flag_of_file_.end() || other->second == output.flag) return {};
  return usage(fmt::format("{}: '{}' is also the output of {}; choose another name", output.flag, output.file,
                           other->second));
}

/// The folder of the output must exist, or be a folder that the command creates. In that folder, no output
/// may have the name of one of the command's own files. Errors: kUsage; kIo.
Result<void> CommandFiles::checkPlace(const NamedOutput& output) const {
  const fs::path folder = wholeName(output.file).parent_path();
  bool made = false;
  for (const UsedFolder& used : named_.folders) {
    if (auto good = checkReserved(output, used); !good) return good;
    made = made || (!exists(used.name) && isBelow(wholeName(used.name), folder));
  }
  return made ? Result<void>() : checkOutputPath(output.file);
}

Result<void> CommandFiles::checkReserved(const NamedOutput& output, const UsedFolder& used) const {
  const fs::path file = wholeName(output.file), folder = wholeName(used.name);
  if (!isBelow(file, folder)) return {};
  const fs::path within = file.lexically_relative(folder);
  bool reserved = used.use == FolderUse::kCache;
  if (used.use == FolderUse::kResults) {
    reserved = std::find(kResultFiles.begin(), kResultFiles.end(), within) != kResultFiles.end() ||
               *within.begin() == kRecordings;
  } else if (used.use == FolderUse::kProducts) {
    reserved =
        std::find(kProductEndings.begin(), kProductEndings.end(), file.extension()) != kProductEndings.end();
  }
  if (!reserved) return {};
  return usage(fmt::format("{}: the folder '{}' has the name '{}' for a file of its own; choose another name",
                           output.flag, used.name, output.file));
}

/// Checks for files that stay even with --force. `head`: beginning of the new file; empty: not known.
Result<void> CommandFiles::checkKept(const std::string& what, const std::string& file,
                                     std::string_view head) const {
  if (!exists(file)) return {};
  if (named_.inputs.has(file)) {
    return usage(fmt::format("{} is an input of this command; choose another name", what));
  }
  const std::string old = headOf(file);
  if (!keepsResults(old) || (!head.empty() && sameKind(old, head))) return {};
  return usage(fmt::format("{} keeps results of a tournament or tuning; choose another name", what));
}

std::string CommandFiles::advice() const {
  return named_.can_force ? "use --force to replace it" : "choose another name";
}

Result<void> CommandFiles::checkExisting(const NamedOutput& output) const {
  if (!exists(output.file)) return {};
  const std::string what = fmt::format("{}: '{}'", output.flag, output.file);
  const OutputTraits& traits = output.traits;
  if (named_.force || traits.existing == Existing::kLater) return {};
  if (traits.existing == Existing::kRefused) return usage(fmt::format("{} exists; {}", what, advice()));
  const std::string head = headOf(output.file);
  if (head.empty() || isOfKind(head, traits.kind)) return {};
  return usage(fmt::format("{} exists and is not {}; {}", what, wordsOf(traits.kind), advice()));
}

Result<void> CommandFiles::mayAppear(const std::string& file, std::string_view head) const {
  if (!exists(file)) return {};
  const std::string what = fmt::format("'{}'", file);
  if (auto good = checkKept(what, file, head); !good) return good;
  if (named_.force) return {};
  const std::string old = headOf(file);
  if (old.empty() || sameKind(old, head)) return {};
  for (const UsedFolder& used : named_.folders) {
    // A cache replaces damaged files itself.
    if (used.use == FolderUse::kCache && isBelow(wholeName(file), wholeName(used.name))) return {};
  }
  return usage(fmt::format("{} exists and is another kind of file; {}", what, advice()));
}

}  // namespace fulbito::app
