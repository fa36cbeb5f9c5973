// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <certificate_check/check_certificate.hpp>
#include <string>
#include <vector>

#include "watched.hpp"

namespace py = pybind11;
using namespace tensortopo;

namespace {

py::list list_of(const std::vector<certificate::Finding>& findings) {
  py::list list;
  for (const auto& f : findings) list.append(py::make_tuple(f.entity, f.claimed, f.derived));
  return list;
}

py::dict check(const std::string& input, const std::string& surface,
               const std::string& certificate_file, const std::vector<std::string>& modes,
               const std::string& tensor, bool complete, const py::object& progress) {
  using namespace py::literals;
  const certificate::Demands demands{modes, tensor, complete};
  certificate::Report().unmet(demands);  // are they understood?
  const certificate::Report report = python::watched(progress, [&](const python::Progress& tell) {
    return certificate::check_certificate(input, surface, certificate_file, tell);
  });
  const std::vector<std::string> unmet = report.unmet(demands);
  return py::dict("status"_a = report.status(), "certified"_a = report.certified,
                  "refuted"_a = report.refuted, "undecided"_a = report.undecided,
                  "refutations"_a = list_of(report.refutations), "open"_a = list_of(report.open),
                  "unmet"_a = unmet, "text"_a = certificate::to_text(report, unmet));
}

}  // namespace

/// The checker of certificates, and nothing of the library that it checks.
PYBIND11_MODULE(_checker, m) {
  m.doc() = "The independent checker under tensortopo.check.";
  python::translate_cancelled();
  py::register_local_exception<certificate::Malformed>(m, "Malformed", PyExc_ValueError);
  m.def("check", &check, py::arg("input"), py::arg("surface"), py::arg("certificate"),
        py::arg("modes"), py::arg("tensor"), py::arg("complete"), py::arg("progress"));
}
