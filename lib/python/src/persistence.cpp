// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/mode_persistence.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>

#include "mesh.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::object cell_of(const Mesh& self, TetMesh::Index tet) {
  if (tet < 0) return py::none();
  return py::int_(self.mesh.cell_ids[as_size(tet)]);
}

py::dict dict_of(const Mesh& self, const PersistencePair& p) {
  const auto range = [](const ModeRange& r) { return py::make_tuple(r.low, r.high); };
  const auto place = [](const Vector3<double>& v) { return py::make_tuple(v.x, v.y, v.z); };
  const auto if_dead = [&](const py::object& value) { return p.has_death ? value : py::none(); };
  return py::dict(
      "kind"_a = std::string(name_of(p.kind)), "birth"_a = p.birth.middle(),
      "birth_range"_a = range(p.birth), "death"_a = if_dead(py::float_(p.death.middle())),
      "death_range"_a = range(p.death), "angle_persistence"_a = angle_persistence(p),
      "survives"_a = survived_noise(p), "birth_tet"_a = cell_of(self, p.birth_tet),
      "birth_point"_a = place(p.birth_point), "death_tet"_a = if_dead(cell_of(self, p.death_tet)),
      "death_point"_a = if_dead(place(p.death_point)), "curve"_a = p.curve, "tie"_a = p.is_tie,
      "certain"_a = p.is_certain);
}

py::dict persistence(const Mesh& self, const py::object& progress) {
  const ModePersistence made = watched(progress, [&](const Progress& report) {
    return mode_persistence(self.mesh, persistence_input(self.mesh, report));
  });
  py::list pairs, curves;
  for (const PersistencePair& p : made.pairs) pairs.append(dict_of(self, p));
  for (const CurvePersistence& c : made.curves)
    curves.append(py::dict("mode"_a = c.mode, "component"_a = c.component, "closed"_a = c.is_closed,
                           "length"_a = c.length, "pair"_a = c.pair));
  return py::dict(
      "pairs"_a = pairs, "curves"_a = curves,
      "not_proved"_a = py::make_tuple(made.not_proved[0].size(), made.not_proved[1].size()),
      "unresolved_curve_cells"_a = made.unresolved_curve_cells);
}

}  // namespace

void define_persistence(py::class_<Mesh>& mesh) {
  mesh.def("persistence", &persistence, py::arg("progress"));
}

}  // namespace tensortopo::python
