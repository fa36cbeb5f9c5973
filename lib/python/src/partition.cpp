// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "mesh.hpp"
#include "piece_arrays.hpp"
#include "surface_arrays.hpp"
#include "tensortopo/certify/parts_certificate.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/partition/piece_surface.hpp"
#include "tensortopo/partition/restrict_piece.hpp"
#include "tensortopo/partition/seam_numbers.hpp"
#include "tensortopo/partition/surface_seam.hpp"
#include "tensortopo/partition/topology_numbers.hpp"
#include "tensortopo/partition/whole_in_parts.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

using namespace py::literals;
using Index = TetMesh::Index;

constexpr std::array kReasons{
    UnresolvedReason::zero_deviator_inside,   UnresolvedReason::level_constant_in_cell,
    UnresolvedReason::level_constant_on_face, UnresolvedReason::level_constant_on_edge,
    UnresolvedReason::critical_value_in_cell, UnresolvedReason::critical_value_on_face,
    UnresolvedReason::critical_value_on_edge, UnresolvedReason::budget_exhausted,
    UnresolvedReason::inconsistent_samples};

UnresolvedReason reason_named(const std::string& name) {
  for (const UnresolvedReason reason : kReasons)
    if (name_of(reason) == name) return reason;
  throw py::value_error("unresolved: there is no reason '" + name + "'");
}

py::list list_of(const std::vector<UnresolvedOwnedCell>& cells) {
  py::list list;
  for (const auto& cell : cells)
    list.append(py::make_tuple(cell.cell_id, std::string(name_of(cell.reason))));
  return list;
}

py::dict dict_of(PieceSurface&& made) {
  py::dict out;
  put_surface(out, std::move(made.surface));
  out["ordinals"] = array_of<std::int32_t>(std::move(made.ordinals));
  out["ghost_across"] = array_of<std::int64_t>(std::move(made.ghost_across));
  put_cells(out, made);
  out["unresolved"] = list_of(made.unresolved);
  out["not_embedded"] = made.not_embedded;
  out["on_level"] = made.on_level;
  out["isotropic_ids"] = array_of<std::int64_t>(std::move(made.isotropic_ids));
  if (made.topology) {
    TopologyNumbers proofs = numbers_of(*made.topology);
    out["proofs"] = array_of<std::int32_t>(std::move(proofs.integers));
    out["proof_weights"] = array_of<double>(std::move(proofs.weights));
  }
  return out;
}

py::dict piece(const Mesh& self, const std::string& mode, const Input<std::int64_t>& vertex_ids,
               const Input<bool>& owned, std::int64_t whole_cells, double resolution,
               bool all_samples, bool certify, const py::object& progress) {
  require_resolution(resolution);
  const MeshPiece given = piece_of(self, vertex_ids, owned, whole_cells);
  ExtractOptions options;
  options.sampling.resolution = resolution, options.keep_samples = all_samples;
  options.keep_topology = certify;
  const ModeValue value = parse_surface_mode(mode);
  PieceSurface made = watched(progress, [&](const Progress& report) {
    options.progress = report;
    return extract_piece(given, value, options);
  });
  return dict_of(std::move(made));
}

/// All indices of a piece are in range: its arrays may have been altered.
void require_indices(const PieceSurface& piece) {
  const auto in_range = [](Index i, std::size_t count) { return i >= 0 && as_size(i) < count; };
  const SurfaceMesh& s = piece.surface;
  const std::size_t vertices = s.points.size(), triangles = s.triangles.size();
  bool fits = s.normal.size() == vertices && s.medium_eigenvector.size() == vertices &&
              s.dominant_eigenvector.size() == vertices && s.mode.size() == vertices &&
              s.residual.size() == vertices && s.carrier.size() == vertices &&
              s.carrier_vertices.size() == vertices && piece.ordinals.size() == vertices &&
              s.tet.size() == triangles && piece.ghost_across.size() == triangles &&
              piece.cells.points.size() == piece.vertex_ids.size() &&
              piece.cells.tensors.size() == piece.vertex_ids.size() &&
              piece.cells.tets.size() == piece.cells.cell_ids.size();
  for (const auto& t : s.triangles)
    for (const Index v : t) fits = fits && in_range(v, vertices);
  for (const Index t : s.tet) fits = fits && in_range(t, piece.cells.tets.size());
  for (const auto& t : piece.cells.tets)
    for (const Index v : t) fits = fits && in_range(v, piece.vertex_ids.size());
  for (const auto& carrier : s.carrier_vertices)
    for (const Index v : carrier) fits = fits && (v == -1 || in_range(v, piece.vertex_ids.size()));
  for (const Carrier c : s.carrier) fits = fits && c <= Carrier::vertex;
  if (!fits) throw py::value_error("pieces: arrays of one piece do not fit each other");
}

PieceSurface piece_from(const py::dict& d) {
  PieceSurface piece;
  SurfaceMesh& s = piece.surface;
  s.points = rows<Vector3<double>, double>(d, "points");
  s.triangles = rows<std::array<Index, 3>, Index>(d, "triangles");
  s.normal = rows<Vector3<double>, double>(d, "normals");
  s.medium_eigenvector = rows<Vector3<double>, double>(d, "medium_eigenvectors");
  s.dominant_eigenvector = rows<Vector3<double>, double>(d, "dominant_eigenvectors");
  s.mode = numbers<double>(d, "mode");
  s.residual = numbers<double>(d, "residual");
  for (const std::uint8_t c : numbers<std::uint8_t>(d, "carrier"))
    s.carrier.push_back(static_cast<Carrier>(c));
  s.carrier_vertices = rows<std::array<Index, 4>, Index>(d, "carrier_vertices");
  s.tet = numbers<Index>(d, "tet");
  piece.ordinals = numbers<std::int32_t>(d, "ordinals");
  piece.ghost_across = rows<std::array<std::int64_t, 3>, std::int64_t>(d, "ghost_across");
  take_cells(d, piece);
  for (const auto& [id, reason] :
       d["unresolved"].cast<std::vector<std::pair<std::int64_t, std::string>>>())
    piece.unresolved.push_back({id, reason_named(reason)});
  piece.not_embedded = d["not_embedded"].cast<std::vector<std::int64_t>>();
  piece.on_level = d["on_level"].cast<std::vector<std::int64_t>>();
  piece.isotropic_ids = rows<std::array<std::int64_t, 2>, std::int64_t>(d, "isotropic_ids");
  require_indices(piece);
  if (d.contains("proofs"))
    piece.topology =
        topology_of({numbers<std::int32_t>(d, "proofs"), numbers<double>(d, "proof_weights")},
                    {piece.vertex_ids.size(), piece.cells.tets.size(), s.points.size()});
  return piece;
}

py::dict restrict(const py::dict& whole, const Input<std::int64_t>& tets,
                  const Input<std::int64_t>& vertices) {
  const PartNumbers numbers{rows_of<std::array<std::int64_t, 2>>(tets, "cells"),
                            rows_of<std::array<std::int64_t, 2>>(vertices, "vertices")};
  return dict_of(restrict_piece(piece_from(whole), numbers));
}

/// A merged surface for Python.
py::dict dict_of(MergedSurface&& made, const py::object& certificate) {
  py::dict out;
  auto component = std::move(made.surface.component);
  put_surface(out, std::move(made.surface));
  out["component"] = array_of<Index>(std::move(component));
  out["cell_ids"] = array_of<std::int64_t>(std::move(made.cell_ids));
  out["carrier_ids"] = array_of<std::int64_t>(std::move(made.carrier_ids));
  out["unresolved"] = list_of(made.unresolved);
  out["not_embedded"] = made.not_embedded;
  out["certificate"] = certificate;
  return out;
}

/// What Python says of the field of a certificate, and the mode.
/// @param certified  is not None
std::pair<CertificateSubject, ModeValue> certified_mode(const py::object& certified) {
  CertificateSubject subject;
  subject.tensor = certified["tensor"].cast<std::string>();
  subject.components = certified["components"].cast<std::string>();
  subject.points = certified["points"].cast<std::size_t>();
  subject.field_sha256 = certified["sha256"].cast<std::string>();
  return {subject, parse_surface_mode(certified["mode"].cast<std::string>())};
}

py::dict merge(const std::vector<py::dict>& dicts, const py::object& certified) {
  std::vector<PieceSurface> pieces;
  for (const py::dict& d : dicts) pieces.push_back(piece_from(d));
  std::optional<std::pair<CertificateSubject, ModeValue>> about;
  if (!certified.is_none()) about = certified_mode(certified);
  MergedSurface made;
  std::string certificate;
  {
    const py::gil_scoped_release unlocked;
    made = merge_pieces(pieces);
    if (about) certificate = certificate_bytes(made, about->second, about->first);
  }
  return dict_of(std::move(made),
                 about ? py::object(py::bytes(certificate)) : py::object(py::none()));
}

/// The surface of a part, in the numbers of its file.
/// @param components  of each triangle of the piece, its component in the whole
py::dict surface_part(const py::dict& whole, const Input<std::int64_t>& tets,
                      const Input<std::int64_t>& vertices, const Input<Index>& components,
                      const py::object& certified) {
  const PartNumbers numbers{rows_of<std::array<std::int64_t, 2>>(tets, "cells"),
                            rows_of<std::array<std::int64_t, 2>>(vertices, "vertices")};
  const PieceSurface piece = piece_from(whole);
  SurfacePart part =
      part_of(piece, numbers, {components.data(), static_cast<std::size_t>(components.size())});
  py::object certificate = py::none();
  if (!certified.is_none()) {
    const auto [subject, mode] = certified_mode(certified);
    certificate = py::bytes(certificate_bytes(part, mode, subject));
  }
  py::dict out = dict_of(std::move(part.surface), certificate);
  out["whole_component"] = array_of<Index>(std::move(part.whole_component));
  return out;
}

/// @param parts  of each one the names and hashes of its input, output and certificate
py::bytes parts_certificate(const std::string& mode, const std::string& role,
                            const std::vector<std::array<std::array<std::string, 2>, 3>>& parts,
                            const WholeNumbers& whole) {
  std::vector<CertifiedPart> listed;
  for (const auto& [input, output, certificate] : parts)
    listed.push_back({{input[0], input[1]}, {output[0], output[1]}, {certificate[0], certificate[1]}});
  return parts_certificate_bytes(mode, role, listed, whole);
}

/// Of each triangle of a piece, its component in the piece.
py::array components_of_piece(const py::dict& piece) {
  return array_of<Index>(surface_components(piece_from(piece).surface));
}

py::array seam(const py::dict& piece) {
  return array_of<std::int64_t>(numbers_of(seam_of(piece_from(piece))));
}

py::dict join(const std::vector<Input<std::int64_t>>& arrays) {
  std::vector<SurfaceSeam> seams;
  for (const auto& numbers : arrays)
    seams.push_back(seam_of_numbers({numbers.data(), static_cast<std::size_t>(numbers.size())}));
  const JoinedSeams joined = join_seams(seams);
  std::vector<std::int64_t> vertices, triangles, euler, loops;
  for (const auto& component : joined.components) {
    vertices.push_back(component.vertices), triangles.push_back(component.triangles);
    euler.push_back(component.euler_characteristic), loops.push_back(component.boundary_loops);
  }
  py::dict out;
  out["vertices"] = array_of<std::int64_t>(std::move(vertices));
  out["triangles"] = array_of<std::int64_t>(std::move(triangles));
  out["euler_characteristic"] = array_of<std::int64_t>(std::move(euler));
  out["boundary_loops"] = array_of<std::int64_t>(std::move(loops));
  py::list numbers;
  for (const auto& own : joined.numbers) numbers.append(array_of<Index>(std::vector(own)));
  out["numbers"] = numbers;
  return out;
}

}  // namespace

void define_partition(py::module_& m, py::class_<Mesh>& mesh) {
  mesh.def("piece", &piece, py::arg("mode"), py::arg("vertex_ids"), py::arg("owned"),
           py::arg("whole_cells"), py::arg("resolution"), py::arg("all_samples"),
           py::arg("certify"), py::arg("progress"));
  m.def("merge_pieces", &merge, py::arg("pieces"), py::arg("certified"));
  m.def("surface_part", &surface_part, py::arg("piece"), py::arg("cells"), py::arg("vertices"),
        py::arg("components"), py::arg("certified"));
  m.def("parts_certificate", &parts_certificate, py::arg("mode"), py::arg("role"),
        py::arg("parts"), py::arg("whole"));
  m.def("restrict_piece", &restrict, py::arg("piece"), py::arg("cells"), py::arg("vertices"));
  m.def("components_of_piece", &components_of_piece, py::arg("piece"));
  m.def("seam_of", &seam, py::arg("piece"));
  m.def("join_seams", &join, py::arg("seams"));
  py::register_local_exception<PiecesDiffer>(m, "PiecesDiffer", PyExc_ValueError).attr("__doc__") =
      "Pieces do not agree where they meet: they need more layers of cells around those that they "
      "own, or were extracted with different options.";
}

}  // namespace tensortopo::python
