// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "arrays.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/mesh/unmatched_faces.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::python {

namespace {

using Index = TetMesh::Index;

const char* name_of(MeshDefect::Kind kind) {
  using Kind = MeshDefect::Kind;
  switch (kind) {
    case Kind::wrong_length:
      return "wrong_length";
    case Kind::non_finite_point:
      return "non_finite_point";
    case Kind::non_finite_tensor:
      return "non_finite_tensor";
    case Kind::out_of_range:
      return "out_of_range";
    case Kind::index_out_of_range:
      return "index_out_of_range";
    case Kind::repeated_vertex:
      return "repeated_vertex";
    case Kind::degenerate_cell:
      return "degenerate_cell";
    case Kind::inverted_cell:
      return "inverted_cell";
    case Kind::duplicated_cell:
      return "duplicated_cell";
    case Kind::crowded_face:
      return "crowded_face";
    case Kind::overlapping_cells:
      return "overlapping_cells";
  }
  return "other";
}

/// A vertex that no index can hold is one that does not exist.
Index index_of(std::int64_t i) {
  return i < 0 || i > std::numeric_limits<Index>::max() ? Index{-1} : static_cast<Index>(i);
}

std::unique_ptr<Mesh> make_mesh(const Input<double>& points, const Input<double>& tensors,
                                const Input<std::int64_t>& tets,
                                const Input<std::int64_t>& cell_ids) {
  TetMesh mesh;
  mesh.points = rows_of<Vector3<double>>(points, "points");
  mesh.tensors = rows_of<SymmetricTensor<double>>(tensors, "tensors");
  for (const auto& t : rows_of<std::array<std::int64_t, 4>>(tets, "tets"))
    mesh.tets.push_back({index_of(t[0]), index_of(t[1]), index_of(t[2]), index_of(t[3])});
  mesh.cell_ids.assign(cell_ids.data(), cell_ids.data() + cell_ids.size());
  const py::gil_scoped_release unlocked;
  return std::make_unique<Mesh>(std::move(mesh));
}

}  // namespace

Mesh::Mesh(TetMesh given) : mesh(std::move(given)) {
  reoriented = repair_orientation(mesh);
  defects = validate(mesh);
  extractor = std::make_unique<ModeExtractor>(mesh);
}

void define_mesh(py::module_& m) {
  py::class_<Mesh> mesh(m, "Mesh");
  mesh.def(py::init(&make_mesh), py::arg("points"), py::arg("tensors"), py::arg("tets"),
           py::arg("cell_ids"))
      .def_property_readonly(
          "points", [](py::object self) { return view_of<double>(self.cast<Mesh&>().mesh.points, self); })
      .def_property_readonly(
          "tensors",
          [](py::object self) { return view_of<double>(self.cast<Mesh&>().mesh.tensors, self); })
      .def_property_readonly(
          "tets", [](py::object self) { return view_of<Index>(self.cast<Mesh&>().mesh.tets, self); })
      .def_property_readonly("cell_ids",
                             [](py::object self) {
                               return view_of<std::int64_t>(self.cast<Mesh&>().mesh.cell_ids, self);
                             })
      .def_property_readonly("defects",
                             [](const Mesh& self) {
                               py::list list;
                               for (const MeshDefect& d : self.defects)
                                 list.append(py::make_tuple(name_of(d.kind), d.where, d.text));
                               return list;
                             })
      .def_property_readonly("reoriented", [](const Mesh& self) { return self.reoriented; })
      .def("torn_cells",
           [](const Mesh& self) {
             const py::gil_scoped_release unlocked;
             std::vector<OuterFace> outer;
             validate(self.mesh, &outer);
             std::vector<std::int64_t> cells;
             for (const auto& pair : unmatched_faces(self.mesh, outer))
               for (const std::size_t i : pair)
                 cells.push_back(self.mesh.cell_ids[as_size(outer[i].tet)]);
             std::sort(cells.begin(), cells.end());
             cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
             return cells;
           })
      .def("is_isotropic",
           [](const Mesh& self) {
             const py::gil_scoped_release unlocked;
             return !self.mesh.tensors.empty() &&
                    std::all_of(self.mesh.tensors.begin(), self.mesh.tensors.end(),
                                [](const auto& t) { return deviator(t) == Deviator<double>{}; });
           })
      .def("sha256", [](const Mesh& self) {
        const py::gil_scoped_release unlocked;
        return field_sha256(self.mesh);
      });
  define_extraction(mesh);
  define_persistence(mesh);
  define_sweep(mesh);
  define_partition(m, mesh);
  define_curve_pieces(m, mesh);
  define_merged_curves(m);
}

void define_families(py::module_& m) {
  m.def("family_kinds", [] {
    py::list names;
    for (const FieldKind kind : all_field_kinds()) names.append(std::string(name_of(kind)));
    return names;
  });
  m.def(
      "family_member",
      [](const std::string& kind, std::uint64_t seed, int member, int members,
         std::size_t tetrahedra) {
        const auto found = field_kind(kind);
        if (!found) {
          std::string known;
          for (const FieldKind each : all_field_kinds())
            known += (known.empty() ? "" : ", ") + std::string(name_of(each));
          throw py::value_error("kind: there is no '" + kind + "'; there are " + known);
        }
        FamilyMember made;
        std::unique_ptr<Mesh> mesh;
        {
          const py::gil_scoped_release unlocked;
          made = family_member(*found, {seed, member, members, tetrahedra});
          mesh = std::make_unique<Mesh>(std::move(made.mesh));
        }
        py::list modes;
        for (const ModeValue& mode : made.modes) modes.append(mode.text());
        return py::make_tuple(py::cast(std::move(mesh)), modes, made.note);
      },
      py::arg("kind"), py::arg("seed"), py::arg("member"), py::arg("members"),
      py::arg("tetrahedra"));
}

}  // namespace tensortopo::python
