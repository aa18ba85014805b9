#include "bridge/process/keeper/cgroup.hpp"

#include <cerrno>
#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>

#include "bridge/process/keeper/files.hpp"

namespace fulbito::keeper {
namespace {

/// Calls `visit` with the fields of each line, separated by blanks or `separator`.
template <typename Visit>
void forLines(const std::string& text, char separator, Visit visit) {
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    std::vector<std::string> fields(1);
    for (std::size_t k = at; k < end; ++k) {
      if (text[k] == separator) {
        fields.emplace_back();
      } else {
        fields.back() += text[k];
      }
    }
    visit(fields);
    at = end + 1;
  }
}

bool holds(const std::string& list, const std::string& word) {
  return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

/// The mount point of a hierarchy; for version 2, `controller` is empty. Fields as in proc(5), mountinfo.
std::string mountPoint(const std::string& controller) {
  std::string found;
  forLines(readSmallFile("/proc/self/mountinfo"), ' ', [&](const std::vector<std::string>& fields) {
    std::size_t dash = 0;
    while (dash < fields.size() && fields[dash] != "-") ++dash;
    if (dash + 3 >= fields.size() || !found.empty()) return;
    const bool fits = controller.empty()
                          ? fields[dash + 1] == "cgroup2"
                          : fields[dash + 1] == "cgroup" && holds(fields[dash + 3], controller);
    if (fits) found = fields[4];
  });
  return found;
}

/// The folder of this process's group; empty if the hierarchy is not mounted or the mount shows another part.
std::string ownFolder(const std::string& controller) {
  const std::string root = mountPoint(controller);
  if (root.empty()) return {};
  std::string path;
  forLines(readSmallFile("/proc/self/cgroup"), ':', [&](const std::vector<std::string>& fields) {
    if (fields.size() < 3) return;
    const bool fits = controller.empty() ? fields[0] == "0" : holds(fields[1], controller);
    if (fits) path = fields[2];
  });
  const std::string folder = path == "/" ? root : root + path;
  return ::access((folder + "/cgroup.procs").c_str(), F_OK) == 0 ? folder : root;
}

std::string groupName() { return "/fulbito-" + std::to_string(::getpid()); }

/// The number after a key at the beginning of a line.
unsigned long long counter(const std::string& text, const std::string& key) {
  const std::size_t at = ("\n" + text).find("\n" + key);
  return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

bool makeFolder(const std::string& folder) { return ::mkdir(folder.c_str(), 0755) == 0; }

}  // namespace

Cgroup::~Cgroup() {
  for (const std::string& folder : folders_) {
    // The kernel removes dead members a moment after they are reaped.
    for (int attempt = 0; ::rmdir(folder.c_str()) != 0 && errno == EBUSY && attempt < 1000; ++attempt)
      ::usleep(1000);
  }
}

bool Cgroup::makeVersion2(const Order& order, const std::string& parent) {
  const std::string folder = parent + groupName();
  if (!makeFolder(folder)) return false;
  folders_ = {folder};
  const bool made = writeSmallFile(folder + "/memory.max", std::to_string(order.page->memory)) &&
                    writeSmallFile(folder + "/pids.max", std::to_string(order.page->processes + 1));
  if (!made) {
    ::rmdir(folder.c_str());
    folders_.clear();
    return false;
  }
  // Some kernels lack these two files.
  writeSmallFile(folder + "/memory.swap.max", "0");
  writeSmallFile(folder + "/memory.oom.group", "1");
  version2_ = true;
  return true;
}

bool Cgroup::makeVersion1(const Order& order, const std::string& memory_parent,
                          const std::string& pids_parent) {
  const std::string memory = memory_parent + groupName();
  if (!makeFolder(memory)) return false;
  folders_ = {memory};
  bool made = writeSmallFile(memory + "/memory.limit_in_bytes", std::to_string(order.page->memory));
  // This file exists only where swap is accounted.
  writeSmallFile(memory + "/memory.memsw.limit_in_bytes", std::to_string(order.page->memory));
  const std::string pids = pids_parent + groupName();
  if (made && !pids_parent.empty() && makeFolder(pids)) {
    folders_.push_back(pids);
    made = writeSmallFile(pids + "/pids.max", std::to_string(order.page->processes + 1));
  }
  if (made) return true;
  for (const std::string& folder : folders_) ::rmdir(folder.c_str());
  folders_.clear();
  return false;
}

bool Cgroup::make(const Order& order) {
  const std::string own = ownFolder("");
  // A group that has processes cannot give controllers to groups below it. Then a group next to it serves.
  if (!own.empty() && (makeVersion2(order, own) || makeVersion2(order, own.substr(0, own.rfind('/')))))
    return true;
  const std::string memory = ownFolder("memory");
  return !memory.empty() && makeVersion1(order, memory, ownFolder("pids"));
}

bool Cgroup::add(pid_t process) const {
  for (const std::string& folder : folders_) {
    if (!writeSmallFile(folder + "/cgroup.procs", std::to_string(process))) return false;
  }
  return true;
}

bool Cgroup::lostProcess() const {
  if (folders_.empty()) return false;
  return counter(readSmallFile(folders_.front() + (version2_ ? "/memory.events" : "/memory.oom_control")),
                 "oom_kill ") > 0;
}

/// The kernel counts a kill in the group of the killed process, and the shortage in the group with the limit.
/// With version 1, only the peak use shows it: kernels do not count what the limit with swap refuses.
bool Cgroup::reachedLimit() const {
  const auto number = [this](const char* file, const char* key) {
    return counter(readSmallFile(folders_.front() + file), key);
  };
  if (version2_) return number("/memory.events", "oom ") > 0;
  constexpr unsigned long long kMargin = 1 << 20;  // [bytes] memory is charged in batches
  return number("/memory.max_usage_in_bytes", "") + kMargin >= number("/memory.limit_in_bytes", "");
}

bool Cgroup::ranOut() const { return lostProcess() && reachedLimit(); }

bool Cgroup::othersRanOut() const { return lostProcess() && !reachedLimit(); }

}  // namespace fulbito::keeper
