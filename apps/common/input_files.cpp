#include "apps/common/input_files.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <sys/stat.h>

#include "engine/core/system/text_file.hpp"

namespace fulbito::app {
namespace {

namespace fs = std::filesystem;

// [bytes] larger TOML files are not searched for names.
constexpr std::size_t kLargestToml = std::size_t{1} << 20;
constexpr std::size_t kMostEntries = 100'000;  // largest number of entries of a folder that are added
constexpr std::string_view kBetweenNames = " \t\n,=:;'\"";

std::optional<struct stat> statusOf(const std::string& file) {
  struct stat found{};
  if (file.find('\0') != std::string::npos || ::stat(file.c_str(), &found) != 0) return std::nullopt;
  return found;
}

}  // namespace

void InputFiles::addWord(const std::string& word) { addParts(word, {}); }

bool InputFiles::has(const std::string& file) const {
  const auto found = statusOf(file);
  return found && files_.contains({found->st_dev, found->st_ino});
}

/// Adds the names in a word. @param folder  where names are looked up besides the present folder
void InputFiles::addParts(const std::string& word, const std::string& folder) {
  const auto add = [&](const std::string& name) {
    addName(name);
    if (!folder.empty() && !name.starts_with('/')) addName((fs::path(folder) / name).string());
  };
  add(word);
  for (std::size_t begin = 0; begin < word.size();) {
    const std::size_t end = std::min(word.find_first_of(kBetweenNames, begin), word.size());
    if (end > begin && end - begin < word.size()) add(word.substr(begin, end - begin));
    begin = end + 1;
  }
}

void InputFiles::addName(const std::string& name) {
  const auto found = statusOf(name);
  if (!found) return;
  if (S_ISREG(found->st_mode)) return addFile(name);
  if (!S_ISDIR(found->st_mode)) return;
  std::error_code error;
  std::size_t entries = 0;
  for (fs::directory_iterator at(name, error), end; !error && at != end; at.increment(error)) {
    if (++entries > kMostEntries) return;
    if (std::error_code ignored; at->is_regular_file(ignored)) addFile(at->path().string());
  }
}

void InputFiles::addFile(const std::string& name) {
  const auto found = statusOf(name);
  if (!found || !files_.insert({found->st_dev, found->st_ino}).second) return;
  if (const std::string beside = (fs::path(name).parent_path() / "team.toml").string(); statusOf(beside)) {
    if (fs::path(name).filename() != "team.toml") addName(beside);
  }
  if (name.ends_with(".toml")) addNamesIn(name);
}

/// Adds the texts in a TOML file that are names of files.
void InputFiles::addNamesIn(const std::string& toml) {
  const auto text = readFoundFile(toml, kLargestToml);
  if (!text) return;
  const std::string folder = fs::path(toml).parent_path().string();
  for (std::size_t at = text->find_first_of("'\""); at != std::string::npos;) {
    const std::size_t end = text->find_first_of(std::string{(*text)[at], '\n'}, at + 1);
    if (end == std::string::npos) return;
    if (end > at + 1 && (*text)[end] != '\n') addParts(text->substr(at + 1, end - at - 1), folder);
    at = text->find_first_of("'\"", end + 1);
  }
}

}  // namespace fulbito::app
