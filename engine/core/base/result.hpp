#pragma once

#include <string>

#include <tl/expected.hpp>

namespace fulbito {

/// The category of an error in external input (file, flag, packet). Each maps to one exit code of the
/// program.
enum class ErrorCode {
  kUsage,        ///< the caller gave an invalid name or value (exit 2)
  kBadInput,     ///< a file is readable but its content is wrong (exit 3)
  kIo,           ///< a file or folder cannot be read or written (exit 5)
  kInterrupted,  ///< stopped by a signal before the end (exit 130)
};

/// An error that a person can act on: the message names the file, line, key or flag and the allowed range.
struct Error {
  ErrorCode code = ErrorCode::kUsage;
  std::string message;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that returns a Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}

}  // namespace fulbito
