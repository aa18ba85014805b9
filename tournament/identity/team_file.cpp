#include "tournament/identity/team_file.hpp"

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "engine/core/config/toml_reader.hpp"

namespace fulbito {
namespace {

/// Reads the values of one `team.toml`, and reports what is wrong with them.
class TeamFileReader {
 public:
  explicit TeamFileReader(std::string origin) : origin_(std::move(origin)) {}

  Result<void> take(const TomlEntry& entry, TeamFile& file) const {
    if (entry.key == "name") return takeText(entry.key, entry.value, file.name);
    if (entry.key == "version") return takeText(entry.key, entry.value, file.version);
    if (entry.key == "files") return takeFiles(entry, file.files);
    if (entry.key == "deterministic") return takeFlag(entry, file.deterministic);
    const std::string key = printable(entry.key);
    return wrong(entry.line, fmt::format("unknown key '{}'.{}", key, suggestion(key, kKeys)));
  }

 private:
  static inline const std::vector<std::string> kKeys{"name", "version", "files", "deterministic"};

  tl::unexpected<Error> wrong(int line, const std::string& what) const {
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: {}", origin_, line, what));
  }
  tl::unexpected<Error> wrongType(const std::string& key, const TomlValue& value, const char* wanted) const {
    return wrong(value.line, fmt::format("{} must be {}, not {}", key, wanted, typeName(value)));
  }

  Result<void> takeText(const std::string& key, const TomlValue& value, std::string& text) const {
    const auto* given = std::get_if<std::string>(&value.data);
    if (given == nullptr) return wrongType(key, value, "a string");
    text = *given;
    return {};
  }

  Result<void> takeFlag(const TomlEntry& entry, bool& flag) const {
    const auto* given = std::get_if<bool>(&entry.value.data);
    if (given == nullptr) return wrongType(entry.key, entry.value, "true or false");
    flag = *given;
    return {};
  }

  Result<void> takeFiles(const TomlEntry& entry, std::vector<std::string>& files) const {
    const auto* list = std::get_if<TomlArray>(&entry.value.data);
    if (list == nullptr) return wrongType(entry.key, entry.value, "a list of strings");
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string key = fmt::format("files[{}]", i);
      std::string pattern;
      if (auto taken = takeText(key, (*list)[i], pattern); !taken) return taken;
      if (pattern.empty()) return wrong((*list)[i].line, key + " is empty");
      files.push_back(std::move(pattern));
    }
    return {};
  }

  std::string origin_;
};

}  // namespace

Result<TeamFile> parseTeamFile(std::string_view text, const std::string& origin) {
  const auto table = parseToml(text, origin);
  if (!table) return tl::unexpected<Error>(table.error());
  TeamFile file;
  const TeamFileReader reader(origin);
  for (const TomlEntry& entry : table->entries) {
    if (auto taken = reader.take(entry, file); !taken) return tl::unexpected<Error>(taken.error());
  }
  return file;
}

}  // namespace fulbito
