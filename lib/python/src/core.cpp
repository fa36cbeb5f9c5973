// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include <string>

#include "mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "watched.hpp"

namespace py = pybind11;
using namespace tensortopo;

/// What the package's Python sources are written on: numbers and arrays only. Users see those.
PYBIND11_MODULE(_core, m) {
  m.doc() = "The library under the package tensortopo.";
  python::translate_cancelled();
  m.def(
      "parse_mode", [](const std::string& text) { return parse_surface_mode(text).text(); },
      py::arg("text"));
  python::define_tensors(m);
  python::define_mesh(m);
  python::define_families(m);
}
