#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/system/regular_file.hpp"

namespace fulbito {

/// A file that grows line by line; each line reaches the disk before the next is written. It is locked, so
/// that there is only one writer at a time, also across processes.
class AppendedFile {
 public:
  /// Opens or creates the file. Errors: kIo naming it; kUsage when another writer has locked it.
  static Result<AppendedFile> open(const std::string& file);

  /// For reading the existing content, from the start.
  int descriptor() const { return opened_.descriptor(); }
  /// Cuts off everything after the first `size` bytes. Then waits until these bytes and the file's name are
  /// on the disk, because an earlier process may not have synced them. Errors: kIo.
  Result<void> begin(std::uint64_t size);
  /// Appends a line and waits until it is on the disk. If this fails, the line is cut off again and all
  /// further calls return the same error. After a failed sync the state of the disk is unknown: a later sync
  /// may succeed without writing. Errors: kIo, also when another program removed, replaced or changed the
  /// file.
  Result<void> append(std::string_view line);

 private:
  AppendedFile(std::string file, RegularFile opened) : file_(std::move(file)), opened_(std::move(opened)) {}
  Result<void> checkPlace() const;
  Result<void> write(std::string_view bytes) const;
  Result<void> sync() const;
  Result<void> appendAt(std::string_view line);

  std::string file_;
  RegularFile opened_;
  std::uint64_t size_ = 0;  ///< size of all whole lines [bytes]
  Result<void> state_;
};

}  // namespace fulbito
