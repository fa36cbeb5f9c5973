// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "watched.hpp"

#include <exception>
#include <string>

#include "tensortopo/modes/watched_run.hpp"

namespace tensortopo::python {

namespace py = pybind11;

void translate_cancelled() {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Cancelled& error) {
      const py::object type = py::module_::import("tensortopo._errors").attr("Cancelled");
      PyErr_SetString(type.ptr(), error.what());
    }
  });
}

void run_watched(const py::object& callback, const std::function<void(const Progress&)>& work) {
  const auto look = [&](bool fresh, const std::string& stage, double fraction) {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!fresh || callback.is_none()) return;
    const py::object answer = callback(stage, fraction);
    if (answer.ptr() == Py_False) throw Cancelled("cancelled by the progress callback");
  };
  const py::gil_scoped_release unlocked;
  watched_run(work, look);
}

}  // namespace tensortopo::python
