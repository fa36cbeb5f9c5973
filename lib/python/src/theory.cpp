// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tensortopo/theory/verify.hpp"
#include "watched.hpp"

namespace py = pybind11;
using namespace tensortopo;

namespace {

py::list statements() {
  py::list list;
  for (const auto& s : theory::statements())
    list.append(py::make_tuple(s.id, s.paper, s.claim, s.corrected));
  return list;
}

py::list statements_called(const std::string& name) {
  py::list ids;
  for (const auto* s : theory::statements_called(name)) ids.append(s->id);
  return ids;
}

py::list verify(const std::vector<std::string>& ids, std::size_t fields, std::uint64_t seed,
                const std::string& scalar, const py::object& progress) {
  const auto arithmetic = theory::arithmetic_called(scalar);
  if (!arithmetic)
    throw py::value_error("scalar: there is no '" + scalar +
                          "'; there are rational, interval, real100 and double");
  std::vector<const theory::Statement*> chosen;
  for (const std::string& id : ids) {
    chosen.push_back(theory::find_statement(id));
    if (chosen.back() == nullptr) throw py::value_error("theorems: there is no '" + id + "'");
  }
  const auto results = python::watched(progress, [&](const python::Progress& report) {
    const theory::Trials trials = theory::random_trials(seed, fields);
    std::vector<theory::Verification> done;
    for (const auto* statement : chosen) {
      report(statement->id, static_cast<double>(done.size()) / static_cast<double>(chosen.size()));
      done.push_back(theory::verify(*statement, trials, *arithmetic));
    }
    return done;
  });
  py::list list;
  for (const auto& v : results)
    list.append(
        py::make_tuple(v.id, std::string(theory::name(v.verdict)), v.tried, v.witness, v.seconds));
  return list;
}

}  // namespace

/// The paper's statements, tried: a module of its own, which few programs load.
PYBIND11_MODULE(_theory, m) {
  m.doc() = "The statements under tensortopo.verify.";
  python::translate_cancelled();
  m.def("statements", &statements);
  m.def("statements_called", &statements_called, py::arg("name"));
  m.def("verify", &verify, py::arg("ids"), py::arg("fields"), py::arg("seed"), py::arg("scalar"),
        py::arg("progress"));
}
