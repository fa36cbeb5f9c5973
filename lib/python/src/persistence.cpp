// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/mode_homology.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "mesh.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::object cell_of(const TetMesh& mesh, TetMesh::Index tet) {
  if (tet < 0) return py::none();
  return py::int_(mesh.cell_ids[as_size(tet)]);
}

py::dict dict_of(const TetMesh& mesh, const PersistencePair& p) {
  const auto range = [](const ModeRange& r) { return py::make_tuple(r.low, r.high); };
  const auto place = [](const Vector3<double>& v) { return py::make_tuple(v.x, v.y, v.z); };
  const auto if_dead = [&](const py::object& value) { return p.has_death ? value : py::none(); };
  return py::dict("dimension"_a = p.dimension, "kind"_a = std::string(name_of(p.kind)),
                  "birth"_a = p.birth.middle(), "birth_range"_a = range(p.birth),
                  "death"_a = if_dead(py::float_(p.death.middle())),
                  "death_range"_a = range(p.death), "angle_persistence"_a = angle_persistence(p),
                  "survives"_a = survived_noise(p), "birth_tet"_a = cell_of(mesh, p.birth_tet),
                  "birth_point"_a = place(p.birth_point),
                  "death_tet"_a = if_dead(cell_of(mesh, p.death_tet)),
                  "death_point"_a = if_dead(place(p.death_point)), "curve"_a = p.curve,
                  "lasting"_a = p.is_lasting, "tie"_a = p.is_tie, "certain"_a = p.is_certain);
}

py::dict dict_of(const TetMesh& mesh, const LoopEvent& e) {
  return py::dict("kind"_a = std::string(name_of(e.kind)),
                  "event"_a = e.is_birth ? "birth" : "death", "mode"_a = e.mode.middle(),
                  "mode_range"_a = py::make_tuple(e.mode.low, e.mode.high), "count"_a = e.count,
                  "paired"_a = e.paired, "tet"_a = cell_of(mesh, e.tet),
                  "point"_a = py::make_tuple(e.place.x, e.place.y, e.place.z), "curve"_a = e.curve,
                  "tie"_a = e.is_tie);
}

py::list list_of(const std::vector<BettiInterval>& intervals) {
  py::list list;
  for (const BettiInterval& i : intervals)
    list.append(py::dict("low"_a = i.low, "high"_a = i.high,
                         "betti"_a = py::make_tuple(i.betti[0], i.betti[1], i.betti[2])));
  return list;
}

py::dict persistence(const Mesh& self, const py::object& progress) {
  const auto [mesh, made, homology] = watched(progress, [&](const Progress& report) {
    TetMesh ordered = in_canonical_order(self.mesh);
    const PersistenceInput input = persistence_input(ordered, report);
    ModePersistence components = mode_persistence(ordered, input);
    ModeHomology others = mode_homology(ordered, input);
    return std::tuple(std::move(ordered), std::move(components), std::move(others));
  });
  py::list pairs, curves, loops;
  for (const auto* list : {&made.pairs, &homology.pairs})
    for (const PersistencePair& p : *list) pairs.append(dict_of(mesh, p));
  for (const LoopEvent& e : homology.loops) loops.append(dict_of(mesh, e));
  for (const CurvePersistence& c : made.curves)
    curves.append(py::dict("mode"_a = c.mode, "component"_a = c.component, "closed"_a = c.is_closed,
                           "length"_a = c.length, "pair"_a = c.pair));
  return py::dict(
      "pairs"_a = pairs, "curves"_a = curves, "loops"_a = loops,
      "betti"_a = py::dict("superlevel"_a = list_of(homology.betti[0]),
                           "sublevel"_a = list_of(homology.betti[1])),
      "mesh_betti"_a =
          py::make_tuple(homology.mesh_betti[0], homology.mesh_betti[1], homology.mesh_betti[2]),
      "not_proved_voids"_a = py::make_tuple(homology.not_proved[0], homology.not_proved[1]),
      "isotropic_vertices"_a = homology.isotropic_vertices,
      "known_curves"_a = homology.has_known_curves,
      "not_proved"_a = py::make_tuple(made.not_proved[0].size(), made.not_proved[1].size()),
      "unresolved_curve_cells"_a = made.unresolved_curve_cells);
}

}  // namespace

void define_persistence(py::class_<Mesh>& mesh) {
  mesh.def("persistence", &persistence, py::arg("progress"));
}

}  // namespace tensortopo::python
