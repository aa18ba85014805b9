#include "python/bindings/python_calls.hpp"

namespace fulbito::python {

namespace nb = nanobind;

namespace {

nb::object teamError(const std::string& text) {
  return nb::module_::import_("fulbito.errors").attr("TeamError")(text);
}

}  // namespace

void PythonFailure::keep(nb::python_error&& error, const std::string& who) {
  if (any()) return;
  const nb::object value = nb::borrow(error.value());
  if (!PyObject_IsInstance(value.ptr(), PyExc_Exception)) {
    exception_ = value;
    return;
  }
  const nb::object name = value.type().attr("__name__");
  const std::string text = nb::str(value).c_str();
  exception_ = teamError(who + " raised " + nb::str(name).c_str() + (text.empty() ? "" : ": " + text));
  exception_.attr("__cause__") = value;
}

void PythonFailure::keep(const std::string& who, const std::string& text) {
  if (!any()) exception_ = teamError(who + ": " + text);
}

void PythonFailure::raise() {
  if (!any()) return;
  const nb::object exception = std::move(exception_);
  PyErr_SetObject(exception.type().ptr(), exception.ptr());
  throw nb::python_error();
}

SharedFailure newFailure() {
  return {new PythonFailure, [](PythonFailure* failure) {
            const nb::gil_scoped_acquire gil;
            delete failure;
          }};
}

void checkSignals() {
  const nb::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

}  // namespace fulbito::python
