#include "apps/common/outputs.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/command_files.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kForce = "--force";
constexpr const char* kNoName = "{}";  // CLI11 returns this for an option without its optional value

/// The variable that holds the folder or folders of a marked option.
struct FolderMark {
  const std::string* one = nullptr;
  const std::vector<std::string>* many = nullptr;
  FolderUse use{};
};

struct Marks {
  std::map<const CLI::Option*, OutputTraits> outputs;
  std::map<const CLI::Option*, FolderMark> folders;
};

Marks& marks() {
  static Marks all;
  return all;
}

/// The files of the command that is running.
CommandFiles& commandFiles() {
  static CommandFiles files;
  return files;
}

void addFolders(const CLI::Option& option, const FolderMark& mark, NamedFiles& named) {
  for (const std::string& name : mark.one != nullptr ? std::vector{*mark.one} : *mark.many) {
    if (!name.empty()) named.folders.push_back({option.get_name(), name, mark.use});
  }
}

void addWords(const CLI::Option& option, NamedFiles& named) {
  const auto output = marks().outputs.find(&option);
  const bool marked = output != marks().outputs.end();
  if (marked) named.offered.emplace_back(option.get_name(), output->second.kind);
  const std::vector<std::string>& words = option.results();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (marked && output->second.value == i) {
      if (words[i] == kNoName) continue;
      named.outputs.push_back({option.get_name(), words[i], output->second});
    } else {
      named.inputs.addWord(words[i]);
    }
  }
}

NamedFiles namedFiles(const CLI::App& command) {
  NamedFiles named;
  for (const CLI::Option* option : command.get_options()) {
    const auto folder = marks().folders.find(option);
    if (folder != marks().folders.end()) {
      addFolders(*option, folder->second, named);
    } else if (option->get_items_expected_max() > 0) {
      addWords(*option, named);
    } else if (option->get_name() == kForce) {
      named.can_force = true;
      named.force = option->count() > 0;
    }
  }
  return named;
}

}  // namespace

CLI::Option* markOutput(CLI::Option* option, OutputTraits traits) {
  marks().outputs[option] = traits;
  return option;
}

CLI::Option* markFolder(CLI::Option* option, const std::string& folder, FolderUse use) {
  marks().folders[option] = {&folder, nullptr, use};
  return option;
}

CLI::Option* markFolders(CLI::Option* option, const std::vector<std::string>& folders, FolderUse use) {
  marks().folders[option] = {nullptr, &folders, use};
  return option;
}

CLI::Option* addForce(CLI::App& command, const std::string& description) {
  return command.add_flag(kForce, description);
}

Result<void> checkOutputs(const CLI::App& command) {
  NamedFiles named = namedFiles(command);
  const std::vector<NamedOutput> outputs = named.outputs;
  commandFiles() = CommandFiles(std::move(named));
  setReplacementRule(
      [](const std::string& file, std::string_view head) { return commandFiles().mayAppear(file, head); });
  for (const NamedOutput& output : outputs) {
    if (auto may = mayWrite(output); !may) return may;
  }
  return {};
}

Result<void> mayWrite(const NamedOutput& output) { return commandFiles().add(output); }

Result<void> prepareProducts(const std::string& folder, const Products& products) {
  if (auto made = prepareFolder(folder); !made) return made;
  for (const auto& [name, beginning] : products) {
    const std::string file = fmt::format("{}/{}", folder, name);
    if (auto may = commandFiles().mayAppear(file, beginning); !may) return may;
  }
  return {};
}

}  // namespace fulbito::app
