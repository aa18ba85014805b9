#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "bridge/outside/team_command.hpp"
#include "engine/core/config/toml_reader.hpp"
#include "engine/core/system/error_text.hpp"
#include "engine/core/system/text_file.hpp"
#include "navigation/library/library_navigator.hpp"
#include "strategies/interface/team_info.hpp"
#include "tournament/identity/built_sources.hpp"
#include "tournament/identity/file_set.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/identity/team_file.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamesShown = 5;

/// A built-in team and the group of its sources in tournament/identity/sources.txt.
struct BuiltTeam {
  std::string_view team, group;
};
constexpr std::array kBuiltTeams{
    BuiltTeam{"idle", "simple"},      BuiltTeam{"random", "simple"},    BuiltTeam{"chaser", "simple"},
    BuiltTeam{"classic", "classic"},  BuiltTeam{"libero", "libero"},    BuiltTeam{"univector", "sparring"},
    BuiltTeam{"twins", "sparring"},   BuiltTeam{"marker", "sparring"},  BuiltTeam{"block", "sparring"},
    BuiltTeam{"counter", "sparring"}, BuiltTeam{"presser", "sparring"}, BuiltTeam{"dribbler", "sparring"},
    BuiltTeam{"kicker", "sparring"},  BuiltTeam{"spinner", "sparring"}, BuiltTeam{"sweeper", "sparring"}};

std::string_view groupOf(std::string_view team) {
  const auto* at = std::find_if(kBuiltTeams.begin(), kBuiltTeams.end(),
                                [&](const BuiltTeam& built) { return built.team == team; });
  return at == kBuiltTeams.end() ? std::string_view{} : at->group;
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Whether a program belongs to the system: an interpreter such as python3 is not part of a team.
bool isOfSystem(const std::string& program) {
  constexpr std::array kFolders{"/usr/bin/", "/usr/local/bin/", "/bin/"};
  return std::any_of(kFolders.begin(), kFolders.end(), [&](const char* f) { return program.starts_with(f); });
}

/// Collects the parts of a team, in the order in which they are found.
class TeamParts {
 public:
  void addText(std::string_view kind, std::string_view text) {
    hash_.add(kind);
    hash_.add(text);
  }

  Result<void> addFile(const std::string& name, const fs::path& file) {
    const auto content = fileHash(file);
    if (!content) return tl::unexpected<Error>(content.error());
    addText("file", name);
    for (const std::uint64_t word : *content) hash_.add(word);
    names_.push_back(name);
    return {};
  }

  std::string hash() const { return hexText(hash_.value()); }
  bool hasFiles() const { return !names_.empty(); }

  /// The files of the team in words: "2 files: team.py, weights.bin".
  std::string files() const {
    std::vector<std::string> unique = names_;
    std::sort(unique.begin(), unique.end());
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    std::string text = fmt::format("{} {}: ", unique.size(), unique.size() == 1 ? "file" : "files");
    const std::size_t shown = std::min(unique.size(), kNamesShown);
    for (std::size_t i = 0; i < shown; ++i) text += (i > 0 ? ", " : "") + printable(unique[i]);
    if (shown < unique.size()) text += fmt::format(" and {} more", unique.size() - shown);
    return text;
  }

 private:
  WideHash hash_;
  std::vector<std::string> names_;
};

/// The name under which a team's file is hashed: relative to the team's folder, so that the folder may be
/// moved.
std::string nameWithin(const std::string& folder, const fs::path& file) {
  if (folder.empty()) return file.filename().string();
  const fs::path relative = file.lexically_relative(folder);
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return inside ? relative.generic_string() : file.filename().string();
}

/// Adds the files that settings name: a navigator may come from a library of its own.
Result<void> addSettings(const std::vector<Setting>& settings, TeamParts& parts) {
  for (const Setting& setting : settings) {
    parts.addText("setting", setting.name);
    if (setting.name != kNavigatorSetting || !namesLibrary(setting.value)) {
      parts.addText("value", setting.value);
      continue;
    }
    const std::size_t colon = std::min(setting.value.find(':'), setting.value.size());
    const fs::path file = setting.value.substr(0, colon);
    if (auto added = parts.addFile(file.filename().string(), file); !added) return added;
    parts.addText("value", std::string_view(setting.value).substr(colon));
  }
  return {};
}

Result<void> addCommand(const TeamCommandLine& line, TeamParts& parts) {
  for (std::size_t i = 0; i < line.command.size(); ++i) {
    const std::string& word = line.command[i];
    const bool of_machine = i == 0 && (line.from_path || isOfSystem(word));
    if (of_machine || !isFile(word)) {
      parts.addText("word", of_machine ? fs::path(word).filename().string() : word);
    } else if (auto added = parts.addFile(nameWithin(line.folder, word), word); !added) {
      return added;
    }
  }
  return {};
}

/// The `team.toml` of the folder, or default values if there is none.
Result<TeamFile> teamFileOf(const std::string& folder) {
  const fs::path file = fs::path(folder) / kTeamFile;
  std::error_code ignored;
  if (folder.empty() || !fs::exists(fs::symlink_status(file, ignored))) return TeamFile{};
  const auto text = readFoundFile(file.string(), kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseTeamFile(*text, file.string());
}

Result<void> addDeclared(const std::string& folder, const TeamFile& declared, TeamParts& parts) {
  parts.addText("version", declared.version);
  const auto files = filesMatching(folder, declared.files);
  if (!files) {
    const bool of_file = files.error().code == ErrorCode::kBadInput;
    return of_file ? inFile((fs::path(folder) / kTeamFile).string(), files.error())
                   : tl::unexpected<Error>(files.error());
  }
  for (const std::string& file : *files) {
    if (auto added = parts.addFile(file, fs::path(folder) / file); !added) return added;
  }
  return {};
}

Result<void> addListed(const std::vector<std::string>& files, TeamParts& parts) {
  for (const std::string& file : files) {
    if (auto added = parts.addFile(fs::path(file).filename().string(), file); !added) return added;
  }
  return {};
}

Result<TeamIdentity> ofBuiltIn(const Entrant& entrant, std::string_view group) {
  TeamParts parts;
  parts.addText("built-in", entrant.team.info->name);
  parts.addText("sources", sourcesOf(group));
  for (const auto& added : {addSettings(entrant.team.settings, parts), addListed(entrant.files, parts)}) {
    if (!added) return tl::unexpected<Error>(added.error());
  }
  return TeamIdentity{parts.hash(), false, true,
                      parts.hasFiles() ? "built-in sources, " + parts.files() : "built-in sources"};
}

Result<TeamIdentity> ofFiles(const Entrant& entrant) {
  const auto line = parseTeamCommand(entrant.team.text);
  if (!line) return tl::unexpected<Error>(line.error());
  const auto declared = teamFileOf(line->folder);
  if (!declared) return tl::unexpected<Error>(declared.error());
  TeamParts parts;
  parts.addText(line->library ? "library" : "program", sourcesOf("outside"));
  for (const auto& added : {addCommand(*line, parts), addSettings(line->settings, parts),
                            addDeclared(line->folder, *declared, parts), addListed(entrant.files, parts)}) {
    if (!added) return tl::unexpected<Error>(added.error());
  }
  return TeamIdentity{parts.hash(), true, declared->deterministic,
                      parts.hasFiles() ? parts.files() : "its command line only"};
}

/// The identity of a team that a program defines itself; only that program can name its sources.
Result<TeamIdentity> ofProgram(const Entrant& entrant) {
  if (entrant.files.empty()) {
    return fail(ErrorCode::kUsage,
                fmt::format("team '{}': nobody says what determines it; list its files", entrant.team.text));
  }
  TeamParts parts;
  parts.addText("own", entrant.team.text);
  for (const auto& added : {addSettings(entrant.team.settings, parts), addListed(entrant.files, parts)}) {
    if (!added) return tl::unexpected<Error>(added.error());
  }
  return TeamIdentity{parts.hash(), false, true, parts.files()};
}

/// A team that plays elsewhere, such as a client of the league: nobody knows what it is made of.
TeamIdentity ofElsewhere(const Entrant& entrant) {
  TeamParts parts;
  parts.addText("elsewhere", entrant.team.text);
  return TeamIdentity{parts.hash(), true, false, "its specification only"};
}

}  // namespace

Result<TeamIdentity> identityOf(const Entrant& entrant) {
  if (entrant.team.info == nullptr) {
    return fail(ErrorCode::kUsage, fmt::format("entrant '{}' has no team", entrant.name));
  }
  if (isOutside(entrant.team.text)) return ofFiles(entrant);
  if (entrant.team.info->outside && entrant.files.empty()) return ofElsewhere(entrant);
  const std::string_view group = groupOf(entrant.team.info->name);
  return group.empty() ? ofProgram(entrant) : ofBuiltIn(entrant, group);
}

}  // namespace fulbito
