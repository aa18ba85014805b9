#pragma once

#include <functional>
#include <string>

namespace fulbito::test {

/// What came of work in which one system call failed.
struct FailedCall {
  int code = -1;     ///< that the work returned; -1: it crashed or hung
  std::string call;  ///< the call, its process and the errno; empty: the work made no such call
};

/// Runs `work` in a process of its own, in which system call `number`, from 0, fails. Calls of all its
/// processes count that the machine may fail for want of descriptors, processes, memory or a sound disk.
/// Those of a program named `spared` do not count. `variant` picks one of the call's usual errnos.
FailedCall withFailingCall(const std::function<int()>& work, const std::string& spared, int number,
                           int variant);

}  // namespace fulbito::test
