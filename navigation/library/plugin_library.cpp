#include "navigation/library/plugin_library.hpp"

#include <cerrno>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "navigation/library/mapped_length.hpp"

namespace fulbito {
namespace {

thread_local const char* library_of_this_thread = nullptr;

/// The loader's last error message, without the file's name at its start.
std::string loaderReason(const std::string& file) {
  const char* reason = dlerror();
  const std::string text = reason == nullptr ? "unknown reason" : reason;
  return text.starts_with(file + ": ") ? text.substr(file.size() + 2) : text;
}

/// The loader would search for a name without '/' in the system's folders.
std::string fileOf(const std::string& path) {
  return path.find('/') == std::string::npos ? "./" + path : path;
}

Result<void> checkReadable(const std::string& file, const std::string& path) {
  // Checks the effective rights, because a contained team of root has another user id.
  if (faccessat(AT_FDCWD, file.c_str(), R_OK, AT_EACCESS) != 0) {
    const int reason = errno;
    return fail(ioCode(reason), fmt::format("cannot read the library '{}': {}", path,
                                            std::generic_category().message(reason)));
  }
  // The loader would wait for a writer if the file were a pipe.
  std::error_code code;
  if (!std::filesystem::is_regular_file(file, code)) {
    return fail(ErrorCode::kBadInput, fmt::format("the library '{}' is no regular file", path));
  }
  const std::uintmax_t length = std::filesystem::file_size(file, code), needed = mappedLength(file);
  if (!code && length < needed) {
    return fail(ErrorCode::kBadInput,
                fmt::format("the library '{}' is cut: it has {} of {} bytes", path, length, needed));
  }
  return {};
}

}  // namespace

const char* libraryOfThisThread() { return library_of_this_thread; }

LibraryCall::LibraryCall(const std::string& path) : before_(library_of_this_thread) {
  library_of_this_thread = path.c_str();
}

LibraryCall::~LibraryCall() { library_of_this_thread = before_; }

Result<std::shared_ptr<const PluginLibrary>> PluginLibrary::open(const std::string& path) {
  const std::string file = fileOf(path);
  if (auto readable = checkReadable(file, path); !readable) return tl::unexpected<Error>(readable.error());
  void* handle = nullptr;
  {
    const LibraryCall running(path);  // start-up code of -ffast-math changes the thread's floating-point mode
    handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (handle == nullptr) {
    return fail(ErrorCode::kBadInput,
                fmt::format("cannot load the library '{}': {}", path, loaderReason(file)));
  }
  std::shared_ptr<PluginLibrary> library(new PluginLibrary(path, handle));
  if (auto taken = library->takeTable(); !taken) return tl::unexpected<Error>(taken.error());
  return library;
}

PluginLibrary::~PluginLibrary() {
  const LibraryCall running(path_);
  dlclose(handle_);
}

Result<void> PluginLibrary::takeTable() {
  const auto bad = [this](const std::string& what) {
    return fail(ErrorCode::kBadInput, fmt::format("the library '{}' {}", path_, what));
  };
  using Entry = const fulbito_library* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(handle_, FULBITO_ENTRY_NAME));
  if (entry == nullptr) return bad("has no symbol '" FULBITO_ENTRY_NAME "': it is no team of this simulator");
  table_ = callForeign<const fulbito_library*>(*this, nullptr, entry);
  if (table_ == nullptr) return bad("gives no table: '" FULBITO_ENTRY_NAME "' returns null or throws");
  if (table_->abi_version != FULBITO_ABI) {
    return bad(fmt::format("has version {} of the interface; this simulator takes version {}",
                           table_->abi_version, FULBITO_ABI));
  }
  if (table_->struct_size < sizeof(fulbito_library)) {
    return bad(
        fmt::format("has a table of {} bytes instead of {}", table_->struct_size, sizeof(fulbito_library)));
  }
  if (table_->name == nullptr || *table_->name == '\0') return bad("has no name in its table");
  return {};
}

const void* PluginLibrary::extensionNamed(const char* name) const {
  if (table_->get_extension == nullptr) return nullptr;
  return callForeign<const void*>(*this, nullptr, [&] { return table_->get_extension(name); });
}

}  // namespace fulbito
