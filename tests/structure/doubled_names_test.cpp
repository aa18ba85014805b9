#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "tests/structure/definitions.hpp"
#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

// Two types of one name in one namespace are one type for the linker: whichever it meets first (the one
// definition rule). No compiler tells, as no file includes both.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFolders = {"sdk",   "engine",     "navigation",  "strategies", "referee",
                                 "match", "tournament", "experiments", "replays",    "apps",
                                 "bench", "bridge",     "python"};

/// Linked in place of view_window.cpp in a build without a window, never beside it.
constexpr const char* kInsteadOfAnother = "no_window.cpp";

/// Which files define what, over all libraries and the program.
std::map<std::string, std::set<std::string>> filesByName() {
  std::map<std::string, std::set<std::string>> files;
  for (const char* folder : kFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FULBITO_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      if (entry.path().filename() == kInsteadOfAnother) continue;
      const std::string path = fs::relative(entry.path(), FULBITO_SOURCE_DIR);
      for (const Definition& d : definitionsIn(textOf(entry.path()))) files[d.name].insert(path);
    }
  }
  return files;
}

}  // namespace

TEST_CASE("no type and no function is defined in two files", "[unit]") {
  const auto files = filesByName();
  CHECK(files.count("fulbito::World") == 1);
  CHECK(files.size() > 1000);
  for (const auto& [name, paths] : files) {
    if (paths.size() < 2 || name.starts_with("main(")) continue;  // each program has its own
    std::string where;
    for (const std::string& path : paths) where += " " + path;
    FAIL_CHECK(name + " is defined in" + where);
  }
}

TEST_CASE("the scan finds types and functions with their namespaces", "[unit]") {
  const auto found = definitionsIn(R"cpp(
#pragma once
    namespace fulbito {
    struct Block {
      int a = 1;
      struct Inner {};
    };
    struct Declared;
    enum class Kind : int { kOne };
    template <typename T>
    class Box final : public Base<T> {
      void f() {}
    };
    template <>
    struct hash<Kind> {};
    inline double half(double x, const Block& b = {}) { return x / 2; }  // struct Comment {}
    int declared(int x);
    namespace {
    struct Hidden {};
    int hidden() { return 0; }
    }  // namespace
    static int alone() { return 1'000; }
    void Block::member() {
      if (true) {
      }
    }
    Vec2 operator+(Vec2 a, Vec2 b) { return a; }
    const char* const kText = "struct Text {";
    int call(int x = f({1})) { return x; }
    namespace libero {
    struct Block {};
    }  // namespace libero
    }  // namespace fulbito
  )cpp");
  std::vector<std::string> names;
  for (const Definition& d : found) names.push_back((d.is_type ? "type " : "") + d.name);
  CHECK(names == std::vector<std::string>{"type fulbito::Block", "type fulbito::Kind", "type fulbito::Box",
                                          "fulbito::half(double, const Block &)",
                                          "fulbito::operator+(Vec2, Vec2)", "fulbito::call(int)",
                                          "type fulbito::libero::Block"});
}

}  // namespace fulbito::test
