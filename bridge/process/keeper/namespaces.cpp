#include "bridge/process/keeper/namespaces.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <linux/mount.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "bridge/process/keeper/files.hpp"

namespace fulbito::keeper {

pid_t forkInNamespaces(Order& order, bool with_namespaces) {
  if (!with_namespaces) return ::fork();
  unsigned long flags = CLONE_NEWPID | CLONE_NEWNS | SIGCHLD;
  order.own_users = ::geteuid() != 0;
  if (order.own_users) flags |= CLONE_NEWUSER;
  if (order.page->sockets > 0) flags |= CLONE_NEWNET;
  // The system call, not glibc's clone, which needs a stack: this one continues as fork does.
  const auto process = static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, nullptr, nullptr));
  order.own_pids = process >= 0;
  if (process < 0) order.own_users = false;
  return process;
}

int mapUser(const Order& order) {
  if (!order.own_users) return 0;
  const std::string user = std::to_string(order.user), group = std::to_string(order.group);
  // Kernels before 3.19 lack this file and do not require it.
  writeSmallFile("/proc/self/setgroups", "deny");
  if (!writeSmallFile("/proc/self/uid_map", user + " " + user + " 1\n")) return errno;
  if (!writeSmallFile("/proc/self/gid_map", group + " " + group + " 1\n")) return errno;
  return 0;
}

int restrictMounts(Order& order, std::string& why) {
  if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
    why = "cannot separate the mounts";
    return errno;
  }
  // The number of files is limited too, as each costs memory of the kernel.
  const std::string size = "size=" + std::to_string(order.page->folder_size) +
                           ",mode=0700,nr_inodes=16384,uid=" + std::to_string(order.user) +
                           ",gid=" + std::to_string(order.group);
  const char* folder = order.private_folder.c_str();
  if (::mount("fulbito", folder, "tmpfs", MS_NOSUID | MS_NODEV, size.c_str()) != 0) {
    why = "cannot mount the private folder";
    return errno;
  }
  order.page->bounded_folder = true;
  mount_attr unwritable{}, writable{};
  unwritable.attr_set = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID;
  writable.attr_clr = MOUNT_ATTR_RDONLY;
  constexpr unsigned kWholeTree = 0x8000;  // AT_RECURSIVE
  if (::syscall(SYS_mount_setattr, AT_FDCWD, "/", kWholeTree, &unwritable, sizeof unwritable) != 0 ||
      ::syscall(SYS_mount_setattr, AT_FDCWD, folder, 0, &writable, sizeof writable) != 0) {
    why = "cannot make files unwritable";
    return errno;
  }
  order.unwritable = true;
  // If this fails, /proc also shows other processes, but the team still cannot affect them.
  ::mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr);
  return 0;
}

}  // namespace fulbito::keeper
