#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/system/regular_file.hpp"

namespace fulbito {

/// A file that grows line by line, each on the disk before the next. Locked: one writer at a time, also
/// across processes.
class AppendedFile {
 public:
  /// Opens the file or creates it. Errors: kIo naming it; kUsage when another writer has it.
  static Result<AppendedFile> open(const std::string& file);

  /// To read what is there, from the start.
  int descriptor() const { return opened_.descriptor(); }
  /// Cuts off everything after the first `size` bytes, then waits until these and the file's name are on the
  /// disk: what an earlier process wrote may not be yet. Errors: kIo.
  Result<void> begin(std::uint64_t size);
  /// Appends a line and waits for the disk. If that fails, the line is cut off again and all further calls
  /// return the same error: after a failed sync, nobody knows what the disk has (a later one succeeds without
  /// writing). Errors: kIo, also when another program removed, replaced or changed the file.
  Result<void> append(std::string_view line);

 private:
  AppendedFile(std::string file, RegularFile opened) : file_(std::move(file)), opened_(std::move(opened)) {}
  Result<void> checkPlace() const;
  Result<void> write(std::string_view bytes) const;
  Result<void> sync() const;
  Result<void> appendAt(std::string_view line);

  std::string file_;
  RegularFile opened_;
  std::uint64_t size_ = 0;  ///< [bytes] of whole lines
  Result<void> state_;
};

}  // namespace fulbito
