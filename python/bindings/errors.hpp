#pragma once

#include <exception>
#include <nanobind/nanobind.h>
#include <string>
#include <utility>

#include "fulbito/detail/values.hpp"

namespace fulbito::python {

/// An error of the program on its way to Python, where it becomes the subclass of FulbitoError for its code.
class Failure : public std::exception {
 public:
  explicit Failure(Error error) : error_(std::move(error)) {}
  const char* what() const noexcept override { return error_.message.c_str(); }
  ErrorCode code() const { return error_.code; }

 private:
  Error error_;
};

/// An object that cannot be used as it is: after close, by two threads at once, after a fork. Becomes
/// fulbito.StateError.
class StateFailure : public std::exception {
 public:
  explicit StateFailure(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// Throws what Python sees as the exception for `code`.
[[noreturn]] inline void raise(ErrorCode code, std::string message) {
  throw Failure({code, std::move(message)});
}

/// The value of a result; throws its error.
template <typename T>
T valueOf(Result<T> result) {
  if (!result) throw Failure(std::move(result.error()));
  return std::move(*result);
}
inline void valueOf(const Result<void>& result) {
  if (!result) throw Failure(result.error());
}

/// Turns the exceptions above, and broken assertions of the program, into exceptions of fulbito.errors.
void bindErrors(nanobind::module_& m);

}  // namespace fulbito::python
