#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/common/output_kinds.hpp"
#include "fulbito/detail/values.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// One rule for all files that commands write. No output takes the place of an input, of another output, or
/// of a file in which a tournament, a tuning or a cache keeps its results. Without --force, none takes the
/// place of a file of another kind. `checkOutputs` says so before the work starts, and `OutputFile` asks
/// again before it replaces a file. What an option names counts as an input unless the option is marked as an
/// output: an output whose mark was forgotten replaces nothing.
namespace fulbito::app {

/// What "-" means as the name of an output.
enum class Dash { kStdout, kRefused };

/// What happens to a file that has the name of an output, without --force.
enum class Existing {
  kRefused,   ///< it stays, whatever it is
  kReplaced,  ///< it is replaced if it is of the output's kind, as its newest state
  kLater      ///< the command numbers its files, and checks each with `mayWrite`
};

/// What is known of an output besides its name.
struct OutputTraits {
  OutputKind kind{};
  Dash dash = Dash::kRefused;
  Existing existing = Existing::kRefused;
  std::size_t value = 0;  ///< which of the option's values is the name
};

/// Marks an option or argument as the name of an output.
CLI::Option* markOutput(CLI::Option* option, OutputTraits traits);

/// Folders into which commands write.
enum class FolderUse {
  kResults,  ///< of a tournament or tuning, which reads it too
  kCache,    ///< of matches
  kProducts  ///< tables, pictures, recordings: replaced if they are of their kind
};
/// Marks an option or argument as the name of a folder. Its variable must live as long as the option.
CLI::Option* markFolder(CLI::Option* option, const std::string& folder, FolderUse use);
/// The same for an argument that names several.
CLI::Option* markFolders(CLI::Option* option, const std::vector<std::string>& folders, FolderUse use);

/// Adds --force, without which files stay.
CLI::Option* addForce(CLI::App& command, const std::string& description);

/// Checks all outputs of the command that was parsed, and sets the rule for what it writes. Errors: kUsage
/// naming option and file; kIo naming a missing folder.
Result<void> checkOutputs(const CLI::App& command);

/// A file that a command names itself.
struct NamedOutput {
  std::string flag;
  std::string file;
  OutputTraits traits;
};

/// Checks one more output of the command. Errors: as `checkOutputs`.
Result<void> mayWrite(const NamedOutput& output);

/// Products that a command will write into a folder: the name of each, and how its kind begins.
using Products = std::vector<std::pair<std::string, std::string_view>>;

/// Creates the folder of products and checks before the work starts that none of them takes the place of
/// another kind of file. Errors: as `prepareFolder`; kUsage naming the file.
Result<void> prepareProducts(const std::string& folder, const Products& products);

}  // namespace fulbito::app
