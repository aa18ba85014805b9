#include "bridge/outside/team_command.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/text_file.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProgram = "cmd:";
constexpr std::string_view kLibraryEnding = ".so";
constexpr std::string_view kPrograms = "bin";               // the folder of installed programs
constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // [bytes]

std::string_view fileOf(std::string_view specification) {
  return specification.substr(0, specification.find(':'));
}

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string absolute(const std::string& path) {
  std::error_code error;
  const fs::path found = fs::absolute(path, error).lexically_normal();
  return error ? path : found.string();
}

// Splits a text into words as a shell does, with quotes and backslashes, but without variables and patterns.
Result<std::vector<std::string>> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  bool open = false;
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == '\0' && (c == ' ' || c == '\t')) {
      open = false;
      continue;
    }
    if (!open) words.emplace_back();
    open = true;
    if (quote != '\0' && c == quote) {
      quote = '\0';
    } else if (quote == '\0' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == '\\' && quote != '\'' && i + 1 < text.size()) {
      words.back() += text[++i];
    } else {
      words.back() += c;
    }
  }
  if (quote != '\0') return fail(ErrorCode::kUsage, fmt::format("a quote is not closed: {}", quote));
  return words;
}

std::string inPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "/usr/bin:/bin";
  while (true) {
    const std::size_t end = folders.find(':');
    std::string file = fmt::format("{}/{}", folders.substr(0, end), program);
    if (isFile(file) && access(file.c_str(), X_OK) == 0) return file;
    if (end == std::string_view::npos) return {};
    folders.remove_prefix(end + 1);
  }
}

Result<std::string> programOf(const std::string& name) {
  if (name.find('/') == std::string::npos) {
    std::string found = inPath(name);
    if (found.empty()) return fail(ErrorCode::kUsage, fmt::format("there is no program '{}' in PATH", name));
    return found;
  }
  if (!isFile(name)) return fail(ErrorCode::kUsage, fmt::format("there is no file '{}'", name));
  if (access(name.c_str(), X_OK) != 0) {
    return fail(ErrorCode::kUsage, fmt::format("'{}' is not executable (chmod +x)", name));
  }
  return absolute(name);
}

Result<std::string> hashOf(const std::vector<std::string>& command) {
  StateHash hash;
  for (const std::string& argument : command) {
    if (!isFile(argument)) continue;
    const auto content = readTextFile(argument, kLargestFile);
    if (!content) return tl::unexpected<Error>(content.error());
    hash.add(std::string_view(*content));
  }
  return fmt::format("{:016x}", hash.value());
}

Result<TeamCommandLine> parseLibrary(const std::string& specification) {
  TeamCommandLine line;
  line.library = true;
  const std::string file(fileOf(specification));
  if (!isFile(file)) return fail(ErrorCode::kUsage, fmt::format("there is no file '{}'", file));
  line.command = {absolute(file)};
  line.folder = fs::path(line.command.front()).parent_path().string();
  if (file.size() < specification.size()) {
    auto settings = parseSettings(specification.substr(file.size() + 1), specification);
    if (!settings) return tl::unexpected<Error>(settings.error());
    line.settings = std::move(*settings);
  }
  return line;
}

Result<TeamCommandLine> parseProgram(std::string_view text) {
  auto words = wordsOf(text);
  if (!words) return tl::unexpected<Error>(words.error());
  if (words->empty()) return fail(ErrorCode::kUsage, "there is no program after 'cmd:'");
  TeamCommandLine line;
  if (words->size() > 1 && words->back().starts_with(':')) {
    auto settings = parseSettings(words->back().substr(1), "cmd:" + std::string(text));
    if (!settings) return tl::unexpected<Error>(settings.error());
    line.settings = std::move(*settings);
    words->pop_back();
  }
  line.from_path = words->front().find('/') == std::string::npos;
  auto program = programOf(words->front());
  if (!program) return tl::unexpected<Error>(program.error());
  const fs::path folder = fs::path(*program).parent_path();
  const bool installed = line.from_path || folder.filename() == kPrograms;
  if (!installed) line.folder = folder.string();
  line.command.push_back(std::move(*program));
  for (std::size_t i = 1; i < words->size(); ++i) {
    const bool file = isFile((*words)[i]);
    line.command.push_back(file ? absolute((*words)[i]) : (*words)[i]);
    if (file && line.folder.empty()) line.folder = fs::path(line.command.back()).parent_path().string();
  }
  if (line.folder.empty() && !line.from_path) line.folder = folder.string();
  return line;
}

}  // namespace

bool isOutside(const std::string& specification) {
  if (specification.starts_with(kProgram)) return true;
  const std::string_view file = fileOf(specification);
  return file.ends_with(kLibraryEnding) || file.find('/') != std::string_view::npos;
}

Result<TeamCommandLine> parseTeamCommand(const std::string& specification) {
  auto line = specification.starts_with(kProgram)
                  ? parseProgram(std::string_view(specification).substr(kProgram.size()))
                  : parseLibrary(specification);
  if (!line)
    return fail(line.error().code, fmt::format("team '{}': {}", specification, line.error().message));
  auto hash = hashOf(line->command);
  if (!hash) return tl::unexpected<Error>(hash.error());
  line->hash = std::move(*hash);
  return line;
}

}  // namespace fulbito
