#pragma once

#include <memory>
#include <string>

#include "engine/core/base/float_mode.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// A shared library with the C interface of `fulbito/team.h`. It stays loaded as long as the object exists.
class PluginLibrary {
 public:
  /// Loads a library and checks its table. The thread's floating-point mode does not change. Errors name the
  /// file: kIo if it cannot be read, kBadInput if it is no library of this version of the interface.
  static Result<std::shared_ptr<const PluginLibrary>> open(const std::string& path);
  PluginLibrary(const PluginLibrary&) = delete;
  PluginLibrary& operator=(const PluginLibrary&) = delete;
  ~PluginLibrary();

  /// The file, as given.
  const std::string& path() const { return path_; }
  /// The library's table: version, size and name are valid.
  const fulbito_library& table() const { return *table_; }
  /// An extension of the library, or null if it has none with this name.
  template <typename T>
  const T* extension(const char* name) const {
    return static_cast<const T*>(extensionNamed(name));
  }

 private:
  PluginLibrary(std::string path, void* handle) : path_(std::move(path)), handle_(handle) {}
  Result<void> takeTable();
  const void* extensionNamed(const char* name) const;

  std::string path_;
  void* handle_;
  const fulbito_library* table_ = nullptr;
};

/// The file of the library whose code this thread runs at present, or null. Handlers of signals and of `exit`
/// use it.
const char* libraryOfThisThread();

/// As long as the object exists, this thread runs code of a library in the expected floating-point mode. The
/// destructor restores the thread's mode.
class LibraryCall {
 public:
  /// @param path  the library's file; it must outlive the call
  explicit LibraryCall(const std::string& path);
  ~LibraryCall();
  LibraryCall(const LibraryCall&) = delete;
  LibraryCall& operator=(const LibraryCall&) = delete;

 private:
  const char* before_;
  ForeignCall mode_;
};

/// Calls a function of a library. Exceptions, which the interface forbids, give the result `otherwise`.
template <typename R, typename Call>
R callForeign(const PluginLibrary& library, R otherwise, const Call& call) {
  const LibraryCall running(library.path());
  try {
    return call();
  } catch (...) {
    return otherwise;
  }
}

}  // namespace fulbito
