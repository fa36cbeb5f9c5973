// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/arcs/line_ends.hpp"

#include <algorithm>

#include "extract/curves/points/degenerate_points_on_face.hpp"
#include "extract/level/proofs/screen.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/scalar/constants.hpp"

namespace tensortopo {

LineFinder::LineFinder(const TetMesh& mesh, Degeneracy kind)
    : kind_(kind),
      canonical_(canonical_mesh(mesh)),
      field_(canonical_.mesh),
      vertex_(inverse_permutation(canonical_.vertices)),
      tet_(inverse_permutation(canonical_.tets)) {}

ScaledTensor LineFinder::tensor_at(Index vertex) const {
  return {canonical_.mesh.tensors[as_size(vertex)], field_.exponents[as_size(vertex)]};
}

FacePoints LineFinder::points_on(const std::array<Index, 3>& face) const {
  const bool linear = kind_ == Degeneracy::linear;
  std::array<Deviator<double>, 3> rounded;
  for (std::size_t i = 0; i < 3; ++i) rounded[i] = field_.tensors[as_size(face[i])];
  FacePoints found;
  if (screen::excludes(rounded, linear ? 0 : pi<double>() / 3)) return found;
  found = degenerate_points_on_face({tensor_at(face[0]), tensor_at(face[1]), tensor_at(face[2])});
  std::erase_if(found.points, [&](const FacePoint& point) { return point.linear != linear; });
  if (!(linear ? found.concerns_linear : found.concerns_planar)) found.obstacle.reset();
  return found;
}

std::optional<LineEnds> LineFinder::find(const CurveMesh& curves, std::size_t line) const {
  const auto& vertices = canonical_.mesh.tets[as_size(tet_[as_size(curves.tet[line])])];
  LineEnds result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto v = as_size(vertices[i]);
    if (field_.is_zero[v]) return std::nullopt;
    result.points[i] = canonical_.mesh.points[v];
    result.tensors[i] = canonical_.mesh.tensors[v];
    result.scaled[i] = tensor_at(vertices[i]);
  }
  std::vector<BoundaryPoint> boundary;
  std::vector<std::array<Index, 3>> faces;  // of each of these
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Index, 3> face{};
    for (std::size_t k = 0, own = 0; k < 4; ++k)
      if (k != i) face[own++] = vertices[k];
    std::sort(face.begin(), face.end());
    BoundaryPoint point;
    point.face = i;
    for (std::size_t k = 0; k < 3; ++k)
      point.corners[k] =
          as_size(std::find(vertices.begin(), vertices.end(), face[k]) - vertices.begin());
    const FacePoints found = points_on(face);
    if (found.obstacle) return std::nullopt;
    for (const FacePoint& p : found.points) {
      point.point = p;
      boundary.push_back(point);
      faces.push_back(face);
    }
  }
  // The extraction found the same points, bit for bit.
  const auto is_at = [&](std::size_t i, CurveMesh::Index v) {
    if (curves.carrier[as_size(v)] != Carrier::face) return false;
    std::array<Index, 3> face{};
    for (std::size_t k = 0; k < 3; ++k)
      face[k] = vertex_[as_size(curves.carrier_vertices[as_size(v)][k])];
    std::sort(face.begin(), face.end());
    return face == faces[i] && unit_or_zero(vector_cast<double>(boundary[i].point.dominant)) ==
                                   curves.dominant_eigenvector[as_size(v)];
  };
  constexpr double kLargestTurn = 4;  // nobody asks for samples between the ends
  const CurveInTet joined = degenerate_curve_in_tet(result.scaled, boundary, kLargestTurn);
  if (joined.obstacle) return std::nullopt;
  const auto first = curves.lines[line].front(), last = curves.lines[line].back();
  for (const CurvePiece& piece : joined.pieces) {
    const bool is_straight = is_at(piece.begin, first) && is_at(piece.end, last);
    if (!is_straight && !(is_at(piece.begin, last) && is_at(piece.end, first))) continue;
    result.begin = boundary[piece.begin];
    result.end = boundary[piece.end];
    result.is_reversed = !is_straight;
    return result;
  }
  return std::nullopt;
}

}  // namespace tensortopo
