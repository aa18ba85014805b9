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

/// One rule protects files from all outputs of commands. No output replaces an input, another output, or a
/// file with the results of a tournament, a tuning or a cache. Without --force, no output replaces a file of
/// another kind. `checkOutputs` checks this before the work starts, and `OutputFile` again before it replaces
/// a file. The file of an option without a mark counts as an input, so an output whose mark was forgotten
/// replaces nothing.
namespace fulbito::app {

/// The meaning of "-" as the name of an output.
enum class Dash { kStdout, kRefused };

/// What happens without --force to an existing file with the name of an output.
enum class Existing {
  kRefused,   ///< the command fails, whatever the file is
  kReplaced,  ///< the file is replaced if it is of the same kind, because the output is its newer version
  kLater      ///< the command numbers its files, and checks each one with `mayWrite`
};

/// Properties of an output besides its name.
struct OutputTraits {
  OutputKind kind{};
  Dash dash = Dash::kRefused;
  Existing existing = Existing::kRefused;
  std::size_t value = 0;  ///< index of the value of the option that is the name
};

/// Marks an option or argument as the name of an output.
CLI::Option* markOutput(CLI::Option* option, OutputTraits traits);

/// The uses of folders into which commands write.
enum class FolderUse {
  kResults,  ///< results of a tournament or tuning, which also reads them
  kCache,    ///< a cache of matches
  kProducts  ///< tables, pictures, recordings; files of the same kind are replaced
};
/// Marks an option or argument as the name of a folder. Its variable must live as long as the option.
CLI::Option* markFolder(CLI::Option* option, const std::string& folder, FolderUse use);
/// As `markFolder`, for an argument that names several folders.
CLI::Option* markFolders(CLI::Option* option, const std::vector<std::string>& folders, FolderUse use);

/// Adds --force. Without it, existing files stay.
CLI::Option* addForce(CLI::App& command, const std::string& description);

/// Checks all outputs of the parsed command, and sets the rule for files that it writes. Errors: kUsage
/// naming option and file; kIo naming a missing folder.
Result<void> checkOutputs(const CLI::App& command);

/// An output file with its flag.
struct NamedOutput {
  std::string flag;
  std::string file;
  OutputTraits traits;
};

/// Checks one more output of the running command. Errors: as `checkOutputs`.
Result<void> mayWrite(const NamedOutput& output);

/// The files that a command will write into a folder: the name of each, and the first bytes of its kind.
using Products = std::vector<std::pair<std::string, std::string_view>>;

/// Creates the folder for products. Checks before the work starts that no product replaces a file of another
/// kind. Errors: as `prepareFolder`; kUsage naming the file.
Result<void> prepareProducts(const std::string& folder, const Products& products);

}  // namespace fulbito::app
