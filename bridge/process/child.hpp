#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/system/descriptor.hpp"
#include "fulbito/detail/child_limits.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The program to run, and its containment.
struct ChildOptions {
  std::vector<std::string> command;  ///< program, found by PATH unless it contains '/', and its arguments
  /// Folder of the team's files: readable, not writable, and the working directory. Empty: the working
  /// directory is the private folder.
  std::string own_folder;
  std::vector<std::string> readable;  ///< further folders that the child may read: its PYTHONPATH
  /// The child may read only the program's file, not the installation around it. Files that the command names
  /// by absolute paths are always readable.
  bool program_alone = false;
  ChildLimits limits;             ///< limits of the process and its descendants
  bool sandbox_required = false;  ///< refuse to run if a layer is missing
  /// UDP sockets to make in a network of the child's own, for `Child::takeSockets`: at most 8. 0: no own
  /// network. The limits must allow the network.
  int sockets = 0;
};

/// The reason for the end of a child that still ran.
inline constexpr const char* kKilled = "killed";

/// How a child ended.
struct ChildEnd {
  /// Such as "exit code 3" or "signal 11 (Segmentation fault)", or `kKilled`.
  std::string reason;
  /// not the child's fault: the machine lacked something, or somebody killed its keeper
  bool machine = false;
};

/// The layers of containment that a child reached. docs/sandbox.md says what each contains.
struct Containment {
  std::vector<std::string> layers;   ///< such as "process-group", "rlimits", "cgroup", "seccomp", "landlock"
  std::vector<std::string> missing;  ///< layers that this system lacks, each with the reason
};

/// A program in a contained child process with pipes to its standard input and output. Its standard error is
/// captured. Its HOME and TMPDIR are a private folder, removed at the end. When its first process ends, all
/// its other processes end. When this process ends, they all end too. Uses three descriptors. Not
/// thread-safe, but each call may come from another thread.
class Child {
 public:
  /// The result of a wait for output.
  enum class Received : std::uint8_t { kBytes, kNothing, kClosed };

  /// Errors: kUsage if the program does not exist or is not executable, or if a required layer or the own
  /// network is missing; kMachine for everything that fails before the program begins; kInterrupted.
  static Result<Child> launch(const ChildOptions& options);
  Child(Child&&) noexcept;
  Child& operator=(Child&&) noexcept;
  ~Child();

  /// Sends bytes. Bytes that the pipe does not take at once wait for later calls of `send` and `receive`.
  /// @return false if the child no longer reads, or if more than 16 MiB wait
  bool send(std::string_view bytes);
  /// Appends to `into` what the child has written, at most 64 KiB, after waiting at most `seconds` for the
  /// first byte.
  Received receive(std::string& into, double seconds);
  /// Closes the child's standard input, on which a program should end. Bytes that still wait are lost.
  void closeInput();
  /// Standard error since the last call. Keeps at most 64 KiB between calls, and reports the number of bytes
  /// beyond.
  std::string takeErrors();
  /// Begins to end the child, without waiting. Ending one takes 0.1 s per GiB of its memory.
  void stop();
  /// How the child ended. Ends all its processes if it still runs. A child that has closed its output gets
  /// 25 ms to end by itself.
  ChildEnd end();
  /// The sockets of the child's own network, unbound, which do not block. Empty after the first call.
  std::vector<Descriptor> takeSockets();
  /// The containment that was reached.
  const Containment& containment() const;

 private:
  struct Impl;
  explicit Child(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
