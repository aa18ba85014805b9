#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/common/input_files.hpp"
#include "apps/common/outputs.hpp"

namespace fulbito::app {

/// A folder that a command uses.
struct UsedFolder {
  std::string flag;
  std::string name;
  FolderUse use{};
};

/// The files and folders on the command line.
struct NamedFiles {
  InputFiles inputs;
  std::vector<UsedFolder> folders;
  std::vector<NamedOutput> outputs;
  std::vector<std::pair<std::string, OutputKind>> offered;  ///< all options of the command that name outputs
  bool force = false;                                       ///< whether --force was given
  bool can_force = false;                                   ///< whether the command has --force
};

/// Decides which files a command may write.
class CommandFiles {
 public:
  CommandFiles() = default;
  explicit CommandFiles(NamedFiles named) : named_(std::move(named)) {}

  /// Checks an output and remembers it. Errors: kUsage; kIo.
  Result<void> add(const NamedOutput& output);
  /// Whether a new file with this beginning may appear at the path: the `ReplacementRule`.
  Result<void> mayAppear(const std::string& file, std::string_view head) const;

 private:
  Result<void> checkName(const NamedOutput& output) const;
  Result<void> checkApart(const NamedOutput& output) const;
  Result<void> checkPlace(const NamedOutput& output) const;
  Result<void> checkReserved(const NamedOutput& output, const UsedFolder& folder) const;
  Result<void> checkKept(const std::string& what, const std::string& file, std::string_view head) const;
  Result<void> checkExisting(const NamedOutput& output) const;
  std::string advice() const;

  NamedFiles named_;
  std::vector<std::string> to_stdout_;               ///< flags of the outputs that go to stdout
  std::map<std::string, std::string> flag_of_file_;  ///< by resolved path of each output
};

}  // namespace fulbito::app
