#include "tests/unit/bridge/process/children.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Where this program's children have their private folders: nobody else's are there.
const fs::path& temporaryFolder() {
  static const ScratchFolder kFolder;
  static const bool kNamed = ::setenv("TMPDIR", kFolder.path().c_str(), 1) == 0;
  REQUIRE(kNamed);
  return kFolder.path();
}

std::size_t openDescriptors() {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    static_cast<void>(entry);
    ++count;
  }
  return count;
}

bool isNumber(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void addControlGroups(const std::vector<int>& keepers, std::string& left) {
  std::error_code ignored;
  const fs::directory_options options = fs::directory_options::skip_permission_denied;
  for (auto it = fs::recursive_directory_iterator("/sys/fs/cgroup", options, ignored);
       it != fs::recursive_directory_iterator(); it.increment(ignored)) {
    const std::string name = it->path().filename().string();
    for (const int keeper : keepers) {
      if (name == "fulbito-" + std::to_string(keeper)) left += "control group " + it->path().string() + "\n";
    }
  }
}

}  // namespace

std::string misbehavingTeam() {
  const char* named = std::getenv("FULBITO_MISBEHAVING_TEAM");
  return named != nullptr ? named : FULBITO_MISBEHAVING_TEAM;
}

Child launched(const ChildOptions& options) {
  temporaryFolder();
  Result<Child> child = Child::launch(options);
  INFO((child ? std::string() : child.error().message));
  REQUIRE(child);
  return std::move(*child);
}

ChildOptions shell(const std::string& line) {
  ChildOptions options;
  options.command = {"sh", "-c", line};
  return options;
}

std::string allOutput(Child& child, double seconds) {
  std::string text;
  while (child.receive(text, seconds) == Child::Received::kBytes) {
  }
  return text;
}

bool has(const std::vector<std::string>& layers, const std::string& name) {
  return std::find(layers.begin(), layers.end(), name) != layers.end();
}

int processesWith(const std::string& mark) {
  int count = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (!isNumber(name) || name == std::to_string(::getpid())) continue;
    if (content(entry.path() / "cmdline").find(mark) != std::string::npos) ++count;
  }
  return count;
}

Leftovers::Leftovers(std::string mark) : mark_(std::move(mark)) {
  temporaryFolder();
  descriptors_ = openDescriptors();
}

void Leftovers::noteKeepers() {
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    std::istringstream children(content(task.path() / "children"));
    for (int child = 0; children >> child;) keepers_.push_back(child);
  }
}

void Leftovers::killKeepers() const {
  for (const int keeper : keepers_) ::kill(keeper, SIGKILL);
}

std::string Leftovers::found() const {
  std::string left;
  if (openDescriptors() != descriptors_) left += "descriptors\n";
  if (::waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD) left += "a child of this process\n";
  if (const int count = processesWith(mark_); count != 0) left += std::to_string(count) + " processes\n";
  for (const auto& entry : fs::directory_iterator(temporaryFolder()))
    left += "file " + entry.path().string() + "\n";
  addControlGroups(keepers_, left);
  return left;
}

}  // namespace fulbito::test
