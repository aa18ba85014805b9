#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"

namespace fulbito {

/// Makes the folder (and its parents) and proves that it can be written. Errors: kIo naming it.
Result<void> prepareFolder(const std::string& folder);

/// Whether the folder in which `file` shall be made is there, and `file` itself no folder; nothing is made.
/// "-" needs none. Errors: kIo naming what is wrong.
Result<void> checkPlaceOf(const std::string& file);

/// The way on which every output file comes about. What is no plain file (device, pipe) is written to as it
/// is; a link is followed.
class OutputFile {
 public:
  /// A file that is there whole or not at all: its bytes go to a new temporary file beside it until `commit`.
  /// Errors: kIo naming it; kInterrupted while it waits for a pipe's reader.
  static Result<OutputFile> create(const std::string& file);
  /// A file that can be read while it grows. Where one of that name is there already: with `replace` as
  /// `create`, so that the old one is kept until the new one is whole; else an error. Errors: as `create`;
  /// kUsage for a file that is there.
  static Result<OutputFile> grow(const std::string& file, bool replace);

  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;
  /// Without `commit` the temporary file is removed; a growing one stays as it is.
  ~OutputFile();

  /// Appends all bytes or none; after an error further calls do nothing but give it again. Errors: kIo,
  /// kInterrupted while a pipe is full.
  Result<void> write(std::string_view bytes);
  /// Ends the file under its name. `durable`: once the disk has it. Errors: kIo; what was begun is removed
  /// then, unless it is a growing file that has bytes.
  Result<void> commit(bool durable = true);
  /// Removes what was begun.
  void discard();
  /// Where the bytes are until `commit`, for a program that writes them itself.
  const std::string& place() const;
  /// Whether `place` is a device or pipe, which cannot be wound back.
  bool isStream() const;

 private:
  struct Impl;
  explicit OutputFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Writes the whole file or nothing by way of an OutputFile. Not `durable`: without waiting for the disk, for
/// one of many files. Errors: as there.
Result<void> writeFile(const std::string& file, std::string_view content, bool durable = true);

}  // namespace fulbito
