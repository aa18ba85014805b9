#include "bridge/process/keeper/descendants.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <dirent.h>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bridge/process/keeper/files.hpp"

namespace fulbito::keeper {
namespace {

template <typename Visit>
void forNumbers(const std::string& folder, Visit visit) {
  DIR* stream = ::opendir(folder.c_str());
  if (stream == nullptr) return;
  while (const dirent* entry = ::readdir(stream)) {
    const long number = std::strtol(entry->d_name, nullptr, 10);
    if (number > 0) visit(static_cast<pid_t>(number));
  }
  ::closedir(stream);
}

void addChildren(pid_t process, std::vector<pid_t>& children) {
  const std::string tasks = "/proc/" + std::to_string(process) + "/task";
  forNumbers(tasks, [&](pid_t task) {
    const std::string text = readSmallFile(tasks + "/" + std::to_string(task) + "/children");
    const char* next = text.c_str();
    for (char* after = nullptr;; next = after) {
      const long child = std::strtol(next, &after, 10);
      if (after == next || child <= 0) return;
      children.push_back(static_cast<pid_t>(child));
    }
  });
}

std::uint64_t numberAfter(const std::string& text, const char* key) {
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return 0;
  return std::strtoull(text.c_str() + at + std::char_traits<char>::length(key), nullptr, 10);
}

void reapAll() {
  while (::waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

}  // namespace

std::vector<pid_t> descendants(pid_t ancestor) {
  std::vector<pid_t> found;
  addChildren(ancestor, found);
  for (std::size_t k = 0; k < found.size(); ++k) addChildren(found[k], found);
  return found;
}

Usage usage(const std::vector<pid_t>& processes) {
  Usage sum;
  for (const pid_t process : processes) {
    const std::string text = readSmallFile("/proc/" + std::to_string(process) + "/status");
    sum.memory += 1024 * (numberAfter(text, "\nRssAnon:") + numberAfter(text, "\nRssShmem:"));
    sum.tasks += static_cast<int>(numberAfter(text, "\nThreads:"));
  }
  return sum;
}

bool isEnding(pid_t process) {
  const std::string text = readSmallFile("/proc/" + std::to_string(process) + "/stat");
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return true;
  // Fields as in proc(5): state, parent, group, session, terminal, its group, flags. The flag PF_EXITING has
  // always been 4.
  const char* next = text.c_str() + name_end + 2;
  if (*next == 'Z' || *next == 'X') return true;
  char* after = nullptr;
  ++next;
  for (int field = 0; field < 5; ++field, next = after) std::strtol(next, &after, 10);
  constexpr unsigned long kExiting = 4;
  return (std::strtoul(next, nullptr, 10) & kExiting) != 0;
}

int tasksOfUser(uid_t user) {
  int sum = 0;
  forNumbers("/proc", [&](pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process);
    struct stat status{};
    if (::stat(folder.c_str(), &status) != 0 || status.st_uid != user) return;
    forNumbers(folder + "/task", [&](pid_t) { ++sum; });
  });
  return sum;
}

void killDescendants(int seconds) {
  for (int round = 0; round < seconds * 1000; ++round) {
    // Stopping all first keeps a tree from forking faster than it is killed.
    const std::vector<pid_t> found = descendants(::getpid());
    for (const pid_t process : found) ::kill(process, SIGSTOP);
    for (const pid_t process : found) ::kill(process, SIGKILL);
    reapAll();
    if (::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
    ::usleep(1000);
  }
}

}  // namespace fulbito::keeper
