// Private header of apps: not installed.
#pragma once

#include <string>
#include <vector>

#include "engine/core/base/result.hpp"

namespace fulbito::app {

/// What "-" means as the name of an output.
enum class Dash { kStdout, kRefused };

/// A file that a flag or argument names; an empty name: not asked for.
struct NamedFile {
  std::string flag;  ///< "--record", or what stands for an argument: "the recording"
  std::string file;
  Dash dash = Dash::kRefused;
};

/// Whether an output may be made: its folder is there, it does not exist or may be replaced (`force`), or is
/// a device or pipe. Errors: kUsage; kIo naming a folder that is not there.
Result<void> mayWrite(const NamedFile& output, bool force);

/// The same of all outputs of a command, and none of them is an input or another output, whatever `force`
/// says. Names of presets among the inputs are no files. Errors: as `mayWrite`; kUsage naming both flags.
Result<void> mayWriteAll(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs,
                         bool force);

/// Whether two names mean one plain file, also where it is not made yet.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace fulbito::app
