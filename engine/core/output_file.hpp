#pragma once

#include <string>

#include "engine/core/result.hpp"

namespace fulbito {

/// Makes the folder (and its parents) and proves that it can be written. Errors: kIo naming it.
Result<void> prepareFolder(const std::string& folder);

/// Whether the folder in which `file` shall be made is there, and `file` itself no folder; nothing is made.
/// "-" needs none. Errors: kIo naming what is wrong.
Result<void> checkPlaceOf(const std::string& file);

/// Writes the whole file or nothing: to a temporary file beside it, flushed to disk, then renamed. A
/// device or pipe is written to. Errors: kIo naming it. Not `durable`: without waiting
/// for the disk, for one of many files.
Result<void> writeFile(const std::string& file, const std::string& content, bool durable = true);

}  // namespace fulbito
