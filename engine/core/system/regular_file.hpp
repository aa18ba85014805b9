#pragma once

#include <string>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The error "cannot write 'FILE': No space left on device" for a reason of errno: kIo, kMachine where the
/// machine runs short (`ioCode`).
tl::unexpected<Error> ioFailure(const char* what, const std::string& file, int reason);

/// An open regular file, closed at the end.
class RegularFile {
 public:
  /// Opens it with the flags of open(2) and never waits. `what` goes into messages, such as "read". Errors:
  /// kIo naming the file, also if it is no regular file: a device or pipe may have no end.
  static Result<RegularFile> open(const char* what, const std::string& file, int flags);

  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&& other) noexcept;
  ~RegularFile();
  int descriptor() const { return descriptor_; }

 private:
  explicit RegularFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// Waits until the name of a file is in its folder on the disk. Errors: kIo naming the file.
Result<void> syncFolderOf(const std::string& file);

}  // namespace fulbito
