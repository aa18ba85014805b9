#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/wide_hash.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The hash of a file's content, read piece by piece. Errors: kIo naming the file.
Result<WideHashValue> fileHash(const std::filesystem::path& file);

/// Whether a path matches the pattern; both are relative with '/'. `*`, `?` and `[a-z]` match within one
/// name. `**` matches any number of folders, or all files below.
bool matchesPattern(std::string_view pattern, std::string_view path);

/// The files below `folder` that match any of the patterns, as sorted relative paths. Names that begin with a
/// dot and folders `__pycache__` are skipped; links to folders are not followed. Errors: kIo naming the
/// folder; kBadInput, without a file name, for a pattern that matches nothing or leaves the folder, and for a
/// folder with more than 100,000 entries.
Result<std::set<std::string>> filesMatching(const std::filesystem::path& folder,
                                            const std::vector<std::string>& patterns);

}  // namespace fulbito
