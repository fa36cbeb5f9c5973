// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/part_bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/partition/whole_in_parts.hpp"

namespace tensortopo::filters {

namespace {

using Marks = XmlPiece::Attributes;

const Marks kComponentNames{{"ComponentName0", "XX"}, {"ComponentName1", "YY"},
                            {"ComponentName2", "ZZ"}, {"ComponentName3", "XY"},
                            {"ComponentName4", "YZ"}, {"ComponentName5", "XZ"}};
const Marks kIdType{{"IdType", "1"}};
const Marks kPointIds{{"GlobalIds", "GlobalPointIds"}}, kCellIds{{"GlobalIds", "GlobalCellIds"}};
const Marks kSurfaceMarks{{"Scalars", "mode"}, {"Normals", "whole_normal"}};
const Marks kCurveMarks{{"Scalars", "mode"}};

/// The tetrahedra that a rank owns as a mesh of their own, with ids and numbers of all.
struct PartMesh {
  TetMesh mesh;
  PartNumbers numbers;
};

PartMesh owned_mesh(const MeshPiece& piece) {
  PartMesh part;
  std::vector<TetMesh::Index> number(piece.mesh.points.size(), -1);
  for (std::size_t t = 0; t < piece.is_owned.size(); ++t)
    if (piece.is_owned[t] != 0)
      for (const auto v : piece.mesh.tets[t]) number[as_size(v)] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    const std::size_t next = part.mesh.points.size();
    number[v] = static_cast<TetMesh::Index>(next);
    part.numbers.vertices.push_back({piece.vertex_ids[v], static_cast<std::int64_t>(next)});
    part.mesh.points.push_back(piece.mesh.points[v]);
    part.mesh.tensors.push_back(piece.mesh.tensors[v]);
  }
  for (std::size_t t = 0; t < piece.is_owned.size(); ++t) {
    if (piece.is_owned[t] == 0) continue;
    const auto next = static_cast<std::int64_t>(part.mesh.tets.size());
    part.numbers.tets.push_back({piece.mesh.cell_ids[t], next});
    part.mesh.cell_ids.push_back(next);
    auto& tet = part.mesh.tets.emplace_back(piece.mesh.tets[t]);
    for (auto& v : tet) v = number[as_size(v)];
  }
  return part;
}

std::string field_bytes(const PartMesh& part, const std::string& tensor) {
  const TetMesh& mesh = part.mesh;
  std::vector<double> tensors;
  for (const auto& t : mesh.tensors) tensors.insert(tensors.end(), {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz});
  const auto ids = [](const std::vector<std::array<std::int64_t, 2>>& pairs) {
    std::vector<std::int64_t> list;
    for (const auto& [whole, own] : pairs) list.push_back(whole);
    return list;
  };
  XmlPiece out("UnstructuredGrid", {{"NumberOfPoints", std::to_string(mesh.points.size())},
                                    {"NumberOfCells", std::to_string(mesh.tets.size())}});
  Marks marks{{"Tensors", tensor}};
  marks.insert(marks.end(), kPointIds.begin(), kPointIds.end());
  out.begin("PointData", marks);
  out.array(tensor, tensors, 6, kComponentNames);
  out.array("GlobalPointIds", ids(part.numbers.vertices), kIdType);
  out.end();
  out.begin("CellData", kCellIds);
  out.array("GlobalCellIds", ids(part.numbers.tets), kIdType);
  out.end();
  out.begin("Points");
  out.array("Points", mesh.points);
  out.end();
  out.begin("Cells");
  out.cells(mesh.tets);
  constexpr std::uint8_t tetrahedron = 10;
  out.array("types", std::vector<std::uint8_t>(mesh.tets.size(), tetrahedron));
  out.end();
  return out.finish();
}

std::string output_bytes(const SurfacePart& part) {
  const SurfaceMesh& surface = part.surface.surface;
  XmlPiece out("PolyData", {{"NumberOfPoints", std::to_string(surface.points.size())},
                            {"NumberOfVerts", "0"},
                            {"NumberOfPolys", std::to_string(surface.triangles.size())}});
  out.begin("PointData", kSurfaceMarks);
  out.array("mode", surface.mode);
  out.array("medium_eigenvector", surface.medium_eigenvector);
  out.array("dominant_eigenvector", surface.dominant_eigenvector);
  out.array("whole_normal", surface.normal);
  out.array("residual", surface.residual);
  out.end();
  out.begin("CellData");
  out.array("tet", part.surface.cell_ids);
  out.array("component", surface.component);
  out.array("whole_component", part.whole_component);
  out.end();
  out.begin("Points");
  out.array("Points", surface.points);
  out.end();
  out.begin("Polys");
  out.cells(surface.triangles);
  out.end();
  return out.finish();
}

std::string output_bytes(const CurvePart& part) {
  const CurveMesh& curves = part.curves.curves;
  XmlPiece out("PolyData", {{"NumberOfPoints", std::to_string(curves.points.size())},
                            {"NumberOfVerts", "0"},
                            {"NumberOfLines", std::to_string(curves.lines.size())}});
  out.begin("PointData", kCurveMarks);
  out.array("mode", curves.mode);
  out.array("dominant_eigenvector", curves.dominant_eigenvector);
  out.array("residual", curves.residual);
  out.array("separation", curves.separation);
  out.end();
  out.begin("CellData");
  out.array("tet", part.curves.cell_ids);
  out.array("component", curves.component);
  out.array("whole_component", part.whole_component);
  out.end();
  out.begin("Points");
  out.array("Points", curves.points);
  out.end();
  out.begin("Lines");
  out.cells(curves.lines);
  out.end();
  return out.finish();
}

CertificateSubject subject_of_part(const PartMesh& part, const std::string& tensor) {
  CertificateSubject subject;
  subject.tensor = tensor;
  subject.components = "vtk";  // of the part's file
  subject.points = part.mesh.points.size();
  subject.field_sha256 = field_sha256(part.mesh);
  return subject;
}

const std::vector<XmlPieces::Array> kCellArrays{
    {"tet", "Int64", 1, {}}, {"component", "Int32", 1, {}}, {"whole_component", "Int32", 1, {}}};

}  // namespace

std::string tensor_name(const TensorGrid& grid) {
  return grid.tensor.empty() ? "tensor" : grid.tensor;
}

PartBytes part_bytes(const TensorGrid& grid, const PieceSurface& surface, const ModeValue& mode,
                     std::span<const SurfaceMesh::Index> components) {
  const PartMesh mesh = owned_mesh(grid.piece);
  const std::string tensor = tensor_name(grid);
  const SurfacePart part = tensortopo::part_of(surface, mesh.numbers, components);
  return {field_bytes(mesh, tensor), output_bytes(part),
          certificate_bytes(part, mode, subject_of_part(mesh, tensor))};
}

PartBytes part_bytes(const TensorGrid& grid, const PieceCurves& curves,
                     std::span<const CurveMesh::Index> components) {
  const PartMesh mesh = owned_mesh(grid.piece);
  const std::string tensor = tensor_name(grid);
  const CurvePart part = tensortopo::part_of(curves, mesh.numbers, components);
  return {field_bytes(mesh, tensor), output_bytes(part),
          certificate_bytes(part, subject_of_part(mesh, tensor))};
}

XmlPieces field_pieces(const std::string& tensor) {
  XmlPieces pieces{"UnstructuredGrid", {}, {}, {{"Tensors", tensor}}, kCellIds};
  pieces.marks.insert(pieces.marks.end(), kPointIds.begin(), kPointIds.end());
  pieces.points = {{tensor, "Float64", 6, kComponentNames}, {"GlobalPointIds", "Int64", 1, kIdType}};
  pieces.cells = {{"GlobalCellIds", "Int64", 1, kIdType}};
  return pieces;
}

XmlPieces surface_pieces() {
  return {"PolyData",
          {{"mode", "Float64", 1, {}},
           {"medium_eigenvector", "Float64", 3, {}},
           {"dominant_eigenvector", "Float64", 3, {}},
           {"whole_normal", "Float64", 3, {}},
           {"residual", "Float64", 1, {}}},
          kCellArrays,
          kSurfaceMarks,
          {}};
}

XmlPieces curve_pieces() {
  return {"PolyData",
          {{"mode", "Float64", 1, {}},
           {"dominant_eigenvector", "Float64", 3, {}},
           {"residual", "Float64", 1, {}},
           {"separation", "Float64", 1, {}}},
          kCellArrays,
          kCurveMarks,
          {}};
}

}  // namespace tensortopo::filters
