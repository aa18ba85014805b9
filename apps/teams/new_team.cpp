#include "apps/teams/new_team.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/config/embedded_files.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedStarters();

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 40;

/// A kind of team: its files, how it is built, and its specification.
struct Kind {
  std::string_view name;
  std::string_view what;
  std::string_view starter;               ///< folder and file of its source in sdk/starters
  std::string_view header;                ///< header that a C++ source includes
  std::string_view macro;                 ///< macro at the end of a C++ source
  std::vector<std::string_view> sdk;      ///< files of the SDK
  std::vector<std::string_view> details;  ///< folders below fulbito/detail that `sdk` files include
  std::string_view build;                 ///< recipe in the Makefile; empty: there is nothing to build
  std::string_view target;                ///< file that the recipe creates
  std::string_view specification;         ///< specification of the built team
};

const std::array<Kind, 4>& kinds() {
  static const std::array<Kind, 4> kKinds = {{
      {"cpp",
       "a shared library in C++20",
       "cpp/team.cpp",
       "team.hpp",
       "FULBITO_TEAM",
       {"team.h", "team.hpp"},
       {"library"},
       "$(CXX) -std=c++20 -O2 -Wall -Wextra -shared -fPIC -Isdk team.cpp -o team.so",
       "team.so",
       "./team.so"},
      {"c",
       "a shared library in C99",
       "c/team.c",
       "",
       "",
       {"team.h"},
       {},
       "$(CC) -std=c99 -O2 -Wall -Wextra -shared -fPIC -Isdk team.c -o team.so -lm",
       "team.so",
       "./team.so"},
      {"python",
       "a program in Python 3",
       "python/team.py",
       "",
       "",
       {"fulbito_team.py"},
       {},
       "",
       "",
       "cmd:python3 team.py"},
      {"program",
       "a program in C++20",
       "cpp/team.cpp",
       "team_program.hpp",
       "FULBITO_TEAM_PROGRAM",
       {"team.h", "team.hpp", "team_program.hpp"},
       {"library", "lines"},
       "$(CXX) -std=c++20 -O2 -Wall -Wextra -Isdk team.cpp -o team",
       "team",
       "cmd:./team"},
  }};
  return kKinds;
}

const EmbeddedFile& embedded(std::string_view kind, std::string_view file) {
  const auto files = embeddedStarters();
  return *std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) {
    return f.file == file && (kind.empty() || f.kind == kind);
  });
}

std::string replaced(std::string text, std::string_view mark, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += by.size()) {
    text.replace(at, mark.size(), by);
  }
  return text;
}

std::string sourceOf(const Kind& kind, const std::string& name) {
  const std::size_t slash = kind.starter.find('/');
  std::string text(embedded(kind.starter.substr(0, slash), kind.starter.substr(slash + 1)).text);
  text = replaced(std::move(text), "./team.so", kind.specification);
  text = replaced(replaced(std::move(text), "@NAME@", name), "@HEADER@", kind.header);
  return replaced(std::move(text), "@MACRO@", kind.macro);
}

std::string makefileOf(const Kind& kind) {
  const std::string_view source = kind.starter.substr(kind.starter.find('/') + 1);
  return fmt::format(
      "{0}: {1}\n\t{2}\n\ntest: {0}\n\tsh test.sh\n\nclean:\n\trm -f {0} result.json\n\n.PHONY: test clean\n",
      kind.target, source, kind.build);
}

std::string testOf(const Kind& kind, const std::string& name) {
  return fmt::format(
      "#!/bin/sh\n"
      "# Plays the team against `idle`; fails unless it wins. FULBITO names another fulbito than that of "
      "PATH.\n"
      "set -e\n"
      "cd \"$(dirname \"$0\")\"\n"
      "\"${{FULBITO:-fulbito}}\" match '{0}' idle --half-seconds 60 --json > result.json\n"
      "if ! grep -q '\"winner\": *\"blue\"' result.json; then\n"
      "  echo 'test.sh: {1} did not beat idle: see result.json' >&2\n"
      "  exit 1\n"
      "fi\n"
      "echo '{1} beats idle'\n",
      kind.specification, name);
}

std::string readmeOf(const Kind& kind, const std::string& name) {
  const std::string build = kind.build.empty() ? "" : "    make                               build\n";
  const std::string test = kind.build.empty() ? "sh test.sh" : "make test ";
  return fmt::format(
      "# {0}\n\nA team for Fulbito, {1}.\n\n{2}"
      "    {3}                         play against `idle`\n"
      "    fulbito match '{4}' classic --view\n"
      "    fulbito drill '{4}' --drill 3,10,13\n",
      name, kind.what, build, test, kind.specification);
}

Result<void> makeFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_directory(folder, error) || !fs::is_empty(folder, error))) {
    return fail(ErrorCode::kUsage,
                fmt::format("new-team: '{}' is there already and not empty", folder.string()));
  }
  return prepareFolder(folder.string());
}

Result<std::string> nameOf(const NewTeamCommand& options, const fs::path& folder) {
  std::string name = options.name.empty() ? folder.filename().string() : options.name;
  const bool plain = !name.empty() && name.size() <= kLongestName &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == ' ' || c == '-' || c == '_' || c == '.';
                     });
  if (plain) return name;
  return fail(
      ErrorCode::kUsage,
      fmt::format("new-team: '{}' cannot be a name: up to {} letters, digits, spaces, '-', '_' and '.'; "
                  "--name gives another than the folder's",
                  name, kLongestName));
}

/// The place of a file in the new folder. `#include "fulbito/..."` finds the headers; Python's module lies
/// beside the team.
fs::path placeOf(const EmbeddedFile& file) {
  if (file.kind == "python") return fs::path(file.file);
  const fs::path headers = fs::path("sdk") / "fulbito";
  return (file.kind == "fulbito" ? headers : headers / "detail" / file.kind) / file.file;
}

Result<void> writeAll(const Kind& kind, const fs::path& folder, const std::string& name) {
  std::vector<std::pair<fs::path, std::string>> files = {
      {kind.starter.substr(kind.starter.find('/') + 1), sourceOf(kind, name)},
      {"test.sh", testOf(kind, name)},
      {"README.md", readmeOf(kind, name)}};
  if (!kind.build.empty()) files.emplace_back("Makefile", makefileOf(kind));
  for (const std::string_view sdk : kind.sdk) {
    const EmbeddedFile& file = embedded("", sdk);
    files.emplace_back(placeOf(file), std::string(file.text));
  }
  for (const EmbeddedFile& file : embeddedStarters()) {
    if (std::find(kind.details.begin(), kind.details.end(), file.kind) != kind.details.end())
      files.emplace_back(placeOf(file), std::string(file.text));
  }
  for (const auto& [place, text] : files) {
    if (auto made = prepareFolder((folder / place).parent_path().string()); !made) return made;
    if (auto written = writeFile((folder / place).string(), text); !written) return written;
  }
  return {};
}

}  // namespace

CLI::App* addNewTeam(CLI::App& app, NewTeamCommand& options) {
  CLI::App* command = app.add_subcommand("new-team", "write a first version of a team of your own");
  command->footer(
      "Examples:\n"
      "  fulbito new-team python rovers         then: cd rovers && sh test.sh\n"
      "  fulbito new-team cpp rovers            then: cd rovers && make test\n"
      "The folder has the team, its test, and the files of the SDK that it needs.\n"
      "More: docs/write-a-team.md.");
  std::vector<std::string> names;
  std::string help;
  for (const Kind& kind : kinds()) {
    names.emplace_back(kind.name);
    help += fmt::format("{}{}: {}", help.empty() ? "" : "\n", kind.name, kind.what);
  }
  command->add_option("kind", options.kind, help)->required()->check(CLI::IsMember(names));
  command->add_option("folder", options.folder, "folder to create")->required()->type_name("FOLDER");
  command->add_option("--name", options.name, "name of the team (default: the folder's)");
  return command;
}

int newTeam(const NewTeamCommand& options) {
  const auto kind =
      std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == options.kind; });
  const fs::path folder = fs::path(options.folder).lexically_normal();
  const auto name = nameOf(options, folder.has_filename() ? folder : folder.parent_path());
  if (!name) return report(name.error());
  if (auto made = makeFolder(folder); !made) return report(made.error());
  if (auto written = writeAll(*kind, folder, *name); !written) return report(written.error());
  say("{}: {}.\n  cd {}\n  {}    plays it against idle\n", *name, kind->what, folder.string(),
      kind->build.empty() ? "sh test.sh" : "make test");
  return kOk;
}

}  // namespace app
}  // namespace fulbito
