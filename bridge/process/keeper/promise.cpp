#include "bridge/process/keeper/promise.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include "bridge/process/keeper/descendants.hpp"

namespace fulbito::keeper {
namespace {

constexpr std::uint64_t kLeastFiles = 32;  // the number that docs/sandbox.md promises
constexpr int kOwnProcesses = 2;           // the keeper, and the first process of the namespace

/// One limit that a process inherits, with the names that a shell uses to set it.
struct Limit {
  int resource = 0;
  std::uint64_t needed = 0;
  int error = 0;  ///< error that a team would get at the limit
  const char* unit = "";
  const char* flag = "";
};

std::uint64_t mostOf(int resource) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return RLIM_INFINITY;
  return limit.rlim_max;
}

bool refuse(Order& order, const Limit& limit, std::uint64_t most) {
  const std::string text = "give a team " + std::to_string(limit.needed) + limit.unit + ", where ulimit " +
                           limit.flag + " leaves " + std::to_string(most);
  failed(order, text.c_str(), limit.error);
  return false;
}

/// Number of processes that the user may still start. For root, the team has a user of its own.
std::uint64_t processesLeft(const Order& order) {
  const std::uint64_t most = mostOf(RLIMIT_NPROC);
  if (::geteuid() == 0 || most == RLIM_INFINITY) return most;
  struct sysinfo machine{};
  const auto needed = static_cast<std::uint64_t>(order.page->processes) + kOwnProcesses;
  // Counting a user's processes needs a walk over all processes, so this tries a bound first.
  if (::sysinfo(&machine) == 0 && most >= needed + machine.procs) return most;
  return most - std::min(most, static_cast<std::uint64_t>(tasksOfUser(::geteuid())) + kOwnProcesses);
}

}  // namespace

bool canKeepPromise(Order& order) {
  const Page& page = *order.page;
  const auto files = static_cast<std::uint64_t>(page.open_files);
  for (const Limit& limit : {Limit{RLIMIT_NOFILE, std::min(files, kLeastFiles), EMFILE, " open files", "-n"},
                             Limit{RLIMIT_AS, page.memory, ENOMEM, " bytes of memory", "-v"},
                             Limit{RLIMIT_DATA, page.memory, ENOMEM, " bytes of memory", "-d"},
                             Limit{RLIMIT_STACK, kStackSize, ENOMEM, " bytes of stack", "-s"},
                             Limit{RLIMIT_FSIZE, page.file_size, EFBIG, " bytes per file", "-f"}}) {
    if (const std::uint64_t most = mostOf(limit.resource); most < limit.needed) {
      return refuse(order, limit, most);
    }
  }
  const Limit processes{RLIMIT_NPROC, static_cast<std::uint64_t>(page.processes), EAGAIN, " processes", "-u"};
  const std::uint64_t left = processesLeft(order);
  return left >= processes.needed || refuse(order, processes, left);
}

}  // namespace fulbito::keeper
