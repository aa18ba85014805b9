#pragma once

#include <string>

#include "engine/core/output_file.hpp"

namespace fulbito::app {

/// Whether a file may be written: it does not exist, or `force`. Errors: kUsage; kIo naming a folder that is
/// not there.
Result<void> mayWrite(const std::string& file, bool force);

}  // namespace fulbito::app
