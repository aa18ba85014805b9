#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

/// The program under test, run in folders of its own.
namespace fulbito::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct Output {
  int code = 0;
  std::string out;
  std::string err;
};

/// A folder of its own for each test, in which the program runs.
struct Sandbox {
  fs::path path;
  Sandbox() {
    std::string name = (fs::temp_directory_path() / "fulbito-cli-XXXXXX").string();
    path = ::mkdtemp(name.data());
  }
  ~Sandbox() { fs::remove_all(path); }
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  Output run(const std::string& arguments) const {
    return started("cd '" + path.string() + "' && '" FULBITO_PROGRAM "' " + arguments +
                   " >out.txt 2>err.txt </dev/null");
  }
  /// Runs a script of bash in which $F is the program. What a background process writes is lost if it
  /// outlives the script.
  Output shell(const std::string& script) const {
    write("script.sh", "F='" FULBITO_PROGRAM "'\n" + script + "\n");
    const Output output =
        started("cd '" + path.string() + "' && bash script.sh >out.txt 2>err.txt </dev/null");
    fs::remove(path / "script.sh");
    return output;
  }
  /// Runs a command and checks that it works.
  Output works(const std::string& arguments) const {
    Output output = run(arguments);
    INFO(arguments << "\n" << output.err);
    REQUIRE(output.code == 0);
    return output;
  }
  /// Runs a command that must fail before its work: this exit code, this part on stderr, nothing on stdout.
  void fails(const std::string& arguments, int code, const std::string& part = {}) const {
    CHECK(ends(arguments, code, part).out.empty());
  }
  /// Runs a command that ends with this exit code and has this part on stderr.
  Output ends(const std::string& arguments, int code, const std::string& part = {}) const {
    Output output = run(arguments);
    INFO(arguments << "\n" << output.err);
    CHECK(output.code == code);
    CHECK_FALSE(output.err.empty());
    CHECK(contains(output.err, part));
    return output;
  }
  std::string read(const std::string& name) const { return contentOf(path / name); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }

 private:
  Output started(const std::string& command) const {
    const int status = std::system(command.c_str());
    Output output{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(path / "out.txt"),
                  contentOf(path / "err.txt")};
    fs::remove(path / "out.txt");
    fs::remove(path / "err.txt");
    return output;
  }
};

/// Removes what is measured: keys that begin with compute_ or wall_, and x_realtime.
inline void dropMeasured(Json& json) {
  if (json.is_array()) {
    for (Json& item : json) dropMeasured(item);
  } else if (json.is_object()) {
    for (auto it = json.begin(); it != json.end();) {
      const bool measured =
          it.key().starts_with("compute_") || it.key().starts_with("wall_") || it.key() == "x_realtime";
      if (measured) {
        it = json.erase(it);
      } else {
        dropMeasured(*it++);
      }
    }
  }
}

}  // namespace fulbito::test
