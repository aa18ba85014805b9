#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/child_limits.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// What to run, and how it is contained.
struct ChildOptions {
  std::vector<std::string> command;  ///< program, found by PATH unless it contains '/', and its arguments
  /// Folder of the team's files: readable, not writable, and the working directory. Empty: the working
  /// directory is the private folder.
  std::string own_folder;
  std::vector<std::string> readable;  ///< further folders that it may read: its PYTHONPATH
  /// Of the program it may read the file alone, not the installation around it. Files that the command names
  /// by absolute paths are readable always.
  bool program_alone = false;
  ChildLimits limits;             ///< limits of the process and its descendants
  bool sandbox_required = false;  ///< refuse to run if a layer is missing
};

/// How a child ended.
struct ChildEnd {
  /// Such as "exit code 3" or "signal 11 (Segmentation fault)"; "killed": it still ran.
  std::string reason;
  bool machine = false;  ///< the machine failed it, or somebody killed its keeper: not its own fault
};

/// The layers of containment that a child reached. docs/sandbox.md says what each contains.
struct Containment {
  std::vector<std::string> layers;   ///< such as "process-group", "rlimits", "cgroup", "seccomp", "landlock"
  std::vector<std::string> missing;  ///< layers that this system lacks, each with the reason
};

/// A program in a contained child process with pipes to its standard input and output. Its standard error is
/// captured. Its HOME and TMPDIR are a private folder, removed at the end. When its first process ends, so do
/// all others, and when this process ends, all do. Uses three descriptors. Not for several threads at once;
/// any thread may launch and any may go on.
class Child {
 public:
  /// The result of a wait for output.
  enum class Received : std::uint8_t { kBytes, kNothing, kClosed };

  /// Errors: kUsage if the program does not exist or is not executable, or if a required layer is missing;
  /// kMachine for all that fails before the program begins; kInterrupted.
  static Result<Child> launch(const ChildOptions& options);
  Child(Child&&) noexcept;
  Child& operator=(Child&&) noexcept;
  ~Child();

  /// Sends bytes; what the pipe does not take at once is kept and sent with later calls of `send` and
  /// `receive`.
  /// @return false if the child no longer reads, or if more than 16 MiB wait
  bool send(std::string_view bytes);
  /// Appends to `into` what the child has written, at most 64 KiB, after waiting at most `seconds` for the
  /// first byte.
  Received receive(std::string& into, double seconds);
  /// Closes the child's standard input: a good program ends then. What still waits to be sent is lost.
  void closeInput();
  /// Standard error since the last call. At most 64 KiB are kept between calls; more is counted and said.
  std::string takeErrors();
  /// Begins to end the child without a wait. To end one that holds much memory takes 0.1 s per GiB.
  void stop();
  /// How the child ended. Ends all its processes if it still runs. One that has closed its output gets 25 ms
  /// to end by itself.
  ChildEnd end();
  /// The containment that was reached.
  const Containment& containment() const;

 private:
  struct Impl;
  explicit Child(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
