#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// A specification of a team outside the program, taken apart.
struct TeamCommandLine {
  bool library = false;  ///< a shared library; otherwise a program
  std::vector<std::string>
      command;                    ///< the library, or the program and its arguments; files by absolute paths
  std::vector<Setting> settings;  ///< the team's settings
  /// The team's own folder. For a library: its folder. For a program given by its path: its folder, unless
  /// that is named `bin`. Otherwise the folder of the first argument that is a file. Without one: the folder
  /// of a program given by its path, else empty.
  std::string folder;
  bool from_path = false;  ///< the program was found in PATH, so it belongs to the machine, not to the team
  std::string hash;        ///< hash of the content of all files of the command, 16 hexadecimal digits
};

/// Whether a specification names a file or a program, not a team of the catalogue.
bool isOutside(const std::string& specification);

/// Takes a specification apart: `./x.so:key=value` or `cmd:program argument 'one argument' :key=value`.
/// Arguments that name files become absolute paths, as the team runs in a folder of its own. Errors: kUsage
/// for a file or program that does not exist, an open quote or a setting without a value.
Result<TeamCommandLine> parseTeamCommand(const std::string& specification);

}  // namespace fulbito
