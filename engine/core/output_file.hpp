#pragma once

#include <string>

#include "engine/core/result.hpp"

namespace fulbito {

/// Makes the folder (and its parents) and proves that it can be written. Errors: kIo naming it.
Result<void> prepareFolder(const std::string& folder);

/// Whether the folder in which `file` shall be made is there; none is made. "-" needs none. Errors: kIo
/// naming the folder.
Result<void> checkFolderOf(const std::string& file);

/// Writes the whole file or nothing: to a temporary file beside it, flushed to disk, then renamed. A
/// device or pipe is written to. Errors: kIo naming it. Not `durable`: without waiting
/// for the disk, for one of many files.
Result<void> writeFile(const std::string& file, const std::string& content, bool durable = true);

}  // namespace fulbito
