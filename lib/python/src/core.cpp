// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/global_control.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

#include "mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "watched.hpp"

namespace py = pybind11;
using namespace tensortopo;

namespace {

/// The library uses so many threads at most while this lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t count)
      : control_(oneapi::tbb::global_control::max_allowed_parallelism, count) {}

 private:
  oneapi::tbb::global_control control_;
};

}  // namespace

/// What the package's Python sources are written on: numbers and arrays only. Users see those.
PYBIND11_MODULE(_core, m) {
  m.doc() = "The library under the package tensortopo.";
  python::translate_cancelled();
  m.def(
      "parse_mode", [](const std::string& text) { return parse_surface_mode(text).text(); },
      py::arg("text"));
  py::class_<ThreadLimit>(m, "ThreadLimit").def(py::init<std::size_t>(), py::arg("count"));
  python::define_tensors(m);
  python::define_mesh(m);
  python::define_families(m);
}
