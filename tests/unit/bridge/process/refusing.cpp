// Runs a program as if the kernel refused namespaces, as in many containers, and Landlock, as on old kernels:
//   refusing namespaces[,landlock] PROGRAM [ARGUMENT...]

#include <cerrno>
#include <cstdio>
#include <sched.h>
#include <seccomp.h>
#include <string>
#include <unistd.h>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::string refused = argv[1];
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  int wrong = filter == nullptr ? 1 : 0;
  constexpr scmp_datum_t kNew = CLONE_NEWPID;
  if (refused.find("namespaces") != std::string::npos) {
    wrong |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                              SCMP_A0(SCMP_CMP_MASKED_EQ, kNew, kNew));
    wrong |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(unshare), 0);
  }
  if (refused.find("landlock") != std::string::npos) {
    wrong |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(landlock_create_ruleset), 0);
  }
  if (wrong != 0 || seccomp_load(filter) != 0) {
    std::fputs("refusing: cannot install the filter\n", stderr);
    return 2;
  }
  ::execvp(argv[2], argv + 2);
  std::perror(argv[2]);
  return 2;
}
