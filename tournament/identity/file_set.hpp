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

/// Whether the pattern stands for the path, both relative with '/'. `*`, `?` and `[a-z]` stand for parts of a
/// name; `**` stands for any number of folders, or for all files below.
bool matchesPattern(std::string_view pattern, std::string_view path);

/// The files below `folder` that a pattern stands for, as sorted relative paths. Names that begin with a dot
/// and folders `__pycache__` do not belong to it; links to folders are not followed. Errors: kIo naming the
/// folder; kBadInput for a pattern without a file, one that leaves the folder, or a folder with more than
/// 100,000 entries, without naming a file.
Result<std::set<std::string>> filesMatching(const std::filesystem::path& folder,
                                            const std::vector<std::string>& patterns);

}  // namespace fulbito
