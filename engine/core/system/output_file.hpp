#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Creates the folder and its parents and checks that it is writable. Errors: kIo naming it.
Result<void> prepareFolder(const std::string& folder);

/// Checks that the parent folder exists and `file` is not a folder. Creates nothing. "-" always passes.
/// Errors: kIo naming the problem.
Result<void> checkOutputPath(const std::string& file);

/// The most bytes of a file's beginning that a `ReplacementRule` gets.
inline constexpr std::size_t kHeadOfFile = 4096;
/// Whether a new file may take the name `file`, which may exist. `head`: the beginning of the new file.
using ReplacementRule = std::function<Result<void>(const std::string& file, std::string_view head)>;
/// Sets the rule for all files that appear from now on; without one, any file may be replaced. Not while
/// other threads write.
void setReplacementRule(ReplacementRule rule);

/// Writes all output files. Devices and pipes are written to directly; links are followed.
class OutputFile {
 public:
  /// Creates a file that appears complete or not at all: until `commit`, bytes go to a file without a name in
  /// its folder. Where the file system has none, they go to a temporary file, which stays if the process is
  /// killed. Errors: kIo naming it; kInterrupted while waiting for a pipe's reader.
  static Result<OutputFile> create(const std::string& file);
  /// Creates a file that can be read while it grows. If the file exists: with `replace` the same as `create`,
  /// so that the old file stays until the new one is complete; otherwise an error. Errors: as `create`;
  /// kUsage for an existing file.
  static Result<OutputFile> grow(const std::string& file, bool replace);

  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;
  /// Without `commit`, removes the temporary file. A growing file stays as it is.
  ~OutputFile();

  /// Appends all bytes or none. After an error, further calls return the same error. Errors: kIo;
  /// kInterrupted while a pipe is full.
  Result<void> write(std::string_view bytes);
  /// Completes the file under its name. `durable`: waits for the disk. Errors: kIo; of the `ReplacementRule`.
  /// The unfinished file is then removed, unless it is a growing file with content.
  Result<void> commit(bool durable = true);
  /// Removes the unfinished file.
  void discard();
  /// The file that holds the bytes until `commit`, for an external program that writes them.
  const std::string& place() const;
  /// Whether `place` is a device or pipe, which cannot be rewound.
  bool isStream() const;

 private:
  struct Impl;
  explicit OutputFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Writes the whole file or nothing (OutputFile). `durable = false` does not wait for the disk, for one of
/// many files. Errors: as OutputFile.
Result<void> writeFile(const std::string& file, std::string_view content, bool durable = true);

}  // namespace fulbito
