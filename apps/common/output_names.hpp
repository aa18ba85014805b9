#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito::app {

/// What "-" means as the name of an output.
enum class Dash { kStdout, kRefused };

/// A file that a flag or argument names; an empty name means none.
struct NamedFile {
  std::string flag;  ///< "--record", or a description of an argument: "the recording"
  std::string file;
  Dash dash = Dash::kRefused;
};

/// Checks that an output may be written: its folder exists, and it does not exist, may be replaced (`force`),
/// or is a device or pipe. Errors: kUsage; kIo naming a missing folder.
Result<void> mayWrite(const NamedFile& output, bool force);

/// Checks all outputs of a command. None may be an input or another output, even with `force`. Inputs may be
/// names of presets. Errors: as `mayWrite`; kUsage naming both flags.
Result<void> mayWriteAll(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs,
                         bool force);

/// Whether two names mean the same plain file, which need not exist yet.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace fulbito::app
