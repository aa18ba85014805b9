#pragma once

#include <cstdint>
#include <string>

namespace fulbito::keeper {

/// The start of a small file, such as the kernel's; empty if it cannot be read.
std::string readSmallFile(const std::string& path);

/// Writes into an existing file. @return whether the whole text was written; otherwise errno has the reason
bool writeSmallFile(const std::string& path, const std::string& text);

/// Removes a folder and all below it. Follows no links.
void removeTree(const std::string& folder);

/// [bytes] that the files below a folder occupy; stops counting at `most`. A file counts at least 512 bytes,
/// and folders nested deeper than 200 count as `most`.
std::uint64_t treeSize(const std::string& folder, std::uint64_t most);

}  // namespace fulbito::keeper
