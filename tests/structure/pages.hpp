#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace fulbito::test {

/// The pages for people: those of the root, of `docs` and of `tests`, in the order of their paths.
inline std::vector<std::filesystem::path> pages() {
  const std::filesystem::path root = FULBITO_SOURCE_DIR;
  std::vector<std::filesystem::path> files = {root / "README.md", root / "CONTRIBUTING.md",
                                              root / "CHANGELOG.md"};
  for (const char* folder : {"docs", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const bool ours = entry.path().string().find("node_modules") == std::string::npos;
      if (ours && entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace fulbito::test
