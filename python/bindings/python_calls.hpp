#pragma once

#include <memory>
#include <nanobind/nanobind.h>
#include <string>
#include <utility>

namespace fulbito::python {

/// The first exception of Python code that C++ code called, to raise when that C++ code is over. All
/// functions need the GIL.
class PythonFailure {
 public:
  /// Keeps what Python raised, as the cause of a TeamError "WHO raised TYPE: TEXT". An exception that is no
  /// Exception, such as KeyboardInterrupt, is raised as it is.
  void keep(nanobind::python_error&& error, const std::string& who);
  /// Keeps a fault of an answer, as a TeamError "WHO: TEXT".
  void keep(const std::string& who, const std::string& text);
  bool any() const { return exception_.is_valid(); }
  /// Throws what was kept, if there is any.
  void raise();

 private:
  nanobind::object exception_;
};

/// Shared between the caller and what calls Python. Its last owner may lack the GIL.
using SharedFailure = std::shared_ptr<PythonFailure>;
SharedFailure newFailure();

/// A Python object that code without the GIL may hold and destroy.
class HeldObject {
 public:
  explicit HeldObject(nanobind::object object) : object_(std::move(object)) {}
  HeldObject(const HeldObject&) = delete;
  HeldObject& operator=(const HeldObject&) = delete;
  ~HeldObject() {
    const nanobind::gil_scoped_acquire gil;
    object_.reset();
  }
  /// Needs the GIL.
  const nanobind::object& get() const { return object_; }

 private:
  nanobind::object object_;
};

/// Lets Python handle signals: throws KeyboardInterrupt after Ctrl-C. For long calls, without the GIL.
void checkSignals();

}  // namespace fulbito::python
