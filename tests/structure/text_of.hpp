#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace fulbito::test {

/// A file's text; empty where there is no such file.
inline std::string textOf(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace fulbito::test
