#include "python/bindings/errors.hpp"

#include <nanobind/stl/string.h>

#include "engine/core/base/assert.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

const char* classOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::kUsage:
      return "UsageError";
    case ErrorCode::kBadInput:
      return "InputError";
    case ErrorCode::kIo:
      return "FileError";
    case ErrorCode::kMachine:
      return "MachineError";
    case ErrorCode::kInterrupted:
      return "InterruptedRun";
  }
  return "FulbitoError";
}

/// Sets the Python exception. The classes are Python's own, so that they can have several bases.
void set(const char* name, const char* message) {
  try {
    const nb::object type = nb::module_::import_("fulbito.errors").attr(name);
    PyErr_SetString(type.ptr(), message);
  } catch (nb::python_error& error) {
    error.restore();
  }
}

/// nanobind asks this function for each C++ exception that reaches Python.
void translate(const std::exception_ptr& pointer, void*) {
  try {
    std::rethrow_exception(pointer);
  } catch (const Failure& failure) {
    set(classOf(failure.code()), failure.what());
  } catch (const StateFailure& failure) {
    set("StateError", failure.what());
  } catch (const detail::BrokenDemand& broken) {
    set("InternalError", broken.what());
  }
}

}  // namespace

void bindErrors(nb::module_& m) {
  nb::register_exception_translator(translate);
  detail::throwOnBrokenDemand();
  m.def(
      "_fail",
      [](int code, const std::string& message) {
        if (code < 0) detail::demandFailed(message.c_str(), "test", 0);
        if (code > static_cast<int>(ErrorCode::kInterrupted)) throw StateFailure(message);
        raise(static_cast<ErrorCode>(code), message);
      },
      nb::arg("code"), nb::arg("message"),
      "Raises the exception of an error code of the program, from 0 in its order; for tests.");
}

}  // namespace fulbito::python
