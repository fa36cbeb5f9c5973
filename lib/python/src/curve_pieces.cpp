// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "curve_arrays.hpp"
#include "curve_pieces.hpp"
#include "mesh.hpp"
#include "piece_arrays.hpp"
#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/seam_numbers.hpp"
#include "watched.hpp"

namespace tensortopo::python {

namespace {

using Index = TetMesh::Index;

constexpr std::array kObstacles{
    CurveObstacle::zero_deviator_vertex,     CurveObstacle::dependent_tensors_on_face,
    CurveObstacle::degenerate_conic_on_face, CurveObstacle::coincident_points_on_face,
    CurveObstacle::degenerate_point_on_edge, CurveObstacle::dependent_tensors_in_cell,
    CurveObstacle::neutral_characteristic,   CurveObstacle::degenerate_on_a_surface,
    CurveObstacle::degenerate_throughout,    CurveObstacle::no_deviator_in_cell,
    CurveObstacle::points_not_told_apart};

std::vector<OwnedCurveCell> cells_of(const py::dict& d, const char* name) {
  std::vector<OwnedCurveCell> cells;
  for (const auto& [id, reason] :
       d[name].cast<std::vector<std::pair<std::int64_t, std::string>>>()) {
    const auto known =
        std::find_if(kObstacles.begin(), kObstacles.end(),
                     [&text = reason](CurveObstacle o) { return name_of(o) == text; });
    if (known == kObstacles.end())
      throw py::value_error(std::string(name) + ": there is no reason '" + reason + "'");
    cells.push_back({id, *known});
  }
  return cells;
}

Degeneracy degeneracy_named(const std::string& kind) {
  return kind == "planar" ? Degeneracy::planar : Degeneracy::linear;
}

py::dict dict_of(PieceCurves&& made) {
  py::dict out;
  out["kind"] = made.kind == Degeneracy::linear ? "linear" : "planar";
  put_curves(out, std::move(made.curves));
  std::vector<std::uint8_t> kinds, reversed;
  std::vector<std::int32_t> vertex_ordinals, line_ordinals;
  std::vector<std::array<Index, 4>> line_cells;
  for (const auto& vertex : made.keys.vertices) {
    kinds.push_back(static_cast<std::uint8_t>(vertex.kind));
    vertex_ordinals.push_back(vertex.ordinal);
  }
  for (const auto& line : made.keys.lines) {
    line_cells.push_back(line.cell);
    line_ordinals.push_back(line.ordinal);
    reversed.push_back(line.is_reversed ? 1 : 0);
  }
  out["vertex_kinds"] = array_of<std::uint8_t>(std::move(kinds));
  out["vertex_ordinals"] = array_of<std::int32_t>(std::move(vertex_ordinals));
  out["line_cells"] = array_of<Index>(std::move(line_cells));
  out["line_ordinals"] = array_of<std::int32_t>(std::move(line_ordinals));
  out["line_reversed"] = array_of<std::uint8_t>(std::move(reversed));
  out["around"] = array_of<std::uint64_t>(std::move(made.around));
  out["is_shared"] = array_of<std::uint8_t>(
      std::vector<std::uint8_t>(made.is_shared.begin(), made.is_shared.end()));
  put_cells(out, made);
  out["unresolved"] = list_of_cells(made.unresolved);
  out["special"] = list_of_cells(made.special);
  return out;
}

py::dict curve_piece(const Mesh& self, const std::string& kind,
                     const Input<std::int64_t>& vertex_ids, const Input<bool>& owned,
                     std::int64_t whole_cells, double resolution, const py::object& progress) {
  require_resolution(resolution);
  const MeshPiece given = piece_of(self, vertex_ids, owned, whole_cells);
  ExtractOptions options;
  options.sampling.resolution = resolution;
  return dict_of(watched(progress, [&](const Progress& report) {
    options.progress = report;
    return extract_curve_piece(given, degeneracy_named(kind), options);
  }));
}

std::vector<std::vector<Index>> lines_of(const py::dict& d) {
  const auto offsets = numbers<std::int64_t>(d, "offsets");
  const auto connectivity = numbers<Index>(d, "connectivity");
  std::vector<std::vector<Index>> lines;
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    const std::int64_t begin = offsets[i - 1], end = offsets[i];
    if (begin < 0 || end < begin + 2 || as_size(end) > connectivity.size())
      throw py::value_error("pieces: the lines of one are not what they should be");
    lines.emplace_back(connectivity.begin() + begin, connectivity.begin() + end);
  }
  return lines;
}

/// All indices of a piece are in range: its arrays may have been altered.
void require_indices(const PieceCurves& piece) {
  const auto in_range = [](Index i, std::size_t count) { return i >= 0 && as_size(i) < count; };
  const CurveMesh& c = piece.curves;
  const std::size_t vertices = c.points.size(), lines = c.lines.size();
  const std::size_t points = piece.vertex_ids.size();
  bool fits = c.dominant_eigenvector.size() == vertices && c.mode.size() == vertices &&
              c.separation.size() == vertices && c.residual.size() == vertices &&
              c.carrier.size() == vertices && c.carrier_vertices.size() == vertices &&
              piece.keys.vertices.size() == vertices && piece.around.size() == vertices &&
              piece.is_shared.size() == vertices && c.tet.size() == lines &&
              c.component.size() == lines && piece.keys.lines.size() == lines &&
              piece.cells.points.size() == points && piece.cells.tensors.size() == points &&
              piece.cells.tets.size() == piece.cells.cell_ids.size();
  std::vector<char> is_used(vertices, 0);
  for (const auto& line : c.lines)
    for (const Index v : line) {
      fits = fits && in_range(v, vertices);
      if (fits) is_used[as_size(v)] = 1;
    }
  for (const char used : is_used) fits = fits && used != 0;
  for (const Index t : c.tet) fits = fits && in_range(t, piece.cells.tets.size());
  for (const Index n : c.component) fits = fits && in_range(n, lines);
  for (const auto& t : piece.cells.tets)
    for (const Index v : t) fits = fits && in_range(v, points);
  const auto is_simplex = [&](const std::array<Index, 4>& simplex) {
    if (!in_range(simplex[0], points)) return false;
    for (std::size_t i = 1; i < 4; ++i)
      if (simplex[i] != -1 && (simplex[i - 1] == -1 || !in_range(simplex[i], points))) return false;
    return true;
  };
  for (const auto& carrier : c.carrier_vertices) fits = fits && is_simplex(carrier);
  for (const auto& line : piece.keys.lines) fits = fits && is_simplex(line.cell);
  for (const auto& vertex : piece.keys.vertices)
    fits = fits && vertex.kind <= CurveVertexKind::between_ends;
  for (const Carrier carrier : c.carrier) fits = fits && carrier <= Carrier::vertex;
  // Lines end at ends, which are not between them.
  for (const auto& line : c.lines)
    for (std::size_t k = 0; fits && k < line.size(); ++k) {
      const bool is_end = k == 0 || k + 1 == line.size();
      const auto kind = piece.keys.vertices[as_size(line[k])].kind;
      fits = is_end == (kind != CurveVertexKind::between_ends);
    }
  if (!fits) throw py::value_error("pieces: arrays of one piece do not fit each other");
}

}  // namespace

PieceCurves curves_from(const py::dict& d) {
  PieceCurves piece;
  CurveMesh& c = piece.curves;
  piece.kind = degeneracy_named(d["kind"].cast<std::string>());
  c.points = rows<Vector3<double>, double>(d, "points");
  c.lines = lines_of(d);
  c.dominant_eigenvector = rows<Vector3<double>, double>(d, "dominant_eigenvectors");
  c.mode = numbers<double>(d, "mode");
  c.residual = numbers<double>(d, "residual");
  c.separation = numbers<double>(d, "separation");
  for (const std::uint8_t carrier : numbers<std::uint8_t>(d, "carrier"))
    c.carrier.push_back(static_cast<Carrier>(carrier));
  c.carrier_vertices = rows<std::array<Index, 4>, Index>(d, "carrier_vertices");
  c.tet = numbers<Index>(d, "tet");
  c.component = numbers<Index>(d, "component");
  const auto vertex_ordinals = numbers<std::int32_t>(d, "vertex_ordinals");
  for (const std::uint8_t kind : numbers<std::uint8_t>(d, "vertex_kinds")) {
    const std::size_t v = piece.keys.vertices.size();
    if (v < vertex_ordinals.size())
      piece.keys.vertices.push_back({static_cast<CurveVertexKind>(kind), vertex_ordinals[v]});
  }
  const auto line_ordinals = numbers<std::int32_t>(d, "line_ordinals");
  const auto reversed = numbers<std::uint8_t>(d, "line_reversed");
  for (const auto& cell : rows<std::array<Index, 4>, Index>(d, "line_cells")) {
    const std::size_t i = piece.keys.lines.size();
    if (i < line_ordinals.size() && i < reversed.size())
      piece.keys.lines.push_back({cell, line_ordinals[i], reversed[i] != 0});
  }
  piece.around = numbers<std::uint64_t>(d, "around");
  const auto shared = numbers<std::uint8_t>(d, "is_shared");
  piece.is_shared.assign(shared.begin(), shared.end());
  take_cells(d, piece);
  piece.unresolved = cells_of(d, "unresolved");
  piece.special = cells_of(d, "special");
  require_indices(piece);
  return piece;
}

py::list list_of_cells(const std::vector<OwnedCurveCell>& cells) {
  py::list list;
  for (const auto& cell : cells)
    list.append(py::make_tuple(cell.cell_id, std::string(name_of(cell.obstacle))));
  return list;
}

namespace {

py::array curve_seam(const py::dict& piece) {
  return array_of<std::int64_t>(numbers_of(curve_seam_of(curves_from(piece))));
}

py::dict join_curves(const std::vector<Input<std::int64_t>>& arrays) {
  std::vector<CurveSeam> seams;
  for (const auto& numbers : arrays)
    seams.push_back(
        curve_seam_of_numbers({numbers.data(), static_cast<std::size_t>(numbers.size())}));
  const JoinedCurveSeams joined = join_curve_seams(seams);
  std::vector<std::int64_t> vertices, lines, ends, junctions;
  for (const auto& component : joined.components) {
    vertices.push_back(component.vertices), lines.push_back(component.lines);
    ends.push_back(component.ends), junctions.push_back(component.junctions);
  }
  py::dict out;
  out["vertices"] = array_of<std::int64_t>(std::move(vertices));
  out["lines"] = array_of<std::int64_t>(std::move(lines));
  out["ends"] = array_of<std::int64_t>(std::move(ends));
  out["junctions"] = array_of<std::int64_t>(std::move(junctions));
  py::list numbers;
  for (const auto& own : joined.numbers) numbers.append(array_of<Index>(std::vector(own)));
  out["numbers"] = numbers;
  return out;
}

}  // namespace

void define_curve_pieces(py::module_& m, py::class_<Mesh>& mesh) {
  mesh.def("curve_piece", &curve_piece, py::arg("kind"), py::arg("vertex_ids"), py::arg("owned"),
           py::arg("whole_cells"), py::arg("resolution"), py::arg("progress"));
  m.def("curve_seam_of", &curve_seam, py::arg("piece"));
  m.def("join_curve_seams", &join_curves, py::arg("seams"));
}

}  // namespace tensortopo::python
