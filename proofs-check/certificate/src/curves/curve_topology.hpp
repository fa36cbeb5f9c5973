// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The degenerate curves of a field on a mesh, derived from the field alone.
#pragma once

#include "certificate_check/check_certificate.hpp"
#include "curves/curves_in_tet.hpp"
#include "topology.hpp"

namespace certificate {

/// A face with points, or one that is not decided.
struct CurveFace {
  std::array<Vertex, 3> vertices{};
  FacePoints level;

  bool is_decided() const { return level.decided; }
  bool is_crossed() const { return !level.points.empty(); }
};

/// One of the points of a face.
struct MeshPoint {
  std::array<Vertex, 3> face{};
  std::size_t ordinal = 0;

  auto operator<=>(const MeshPoint&) const = default;
};

/// A tetrahedron with pieces of curves, or one that is not decided.
struct CurveTet {
  std::uint32_t tet = 0;
  bool decided = false;
  std::vector<std::array<MeshPoint, 2>> pieces;

  bool is_decided() const { return decided; }
  bool is_crossed() const { return !pieces.empty(); }
};

/// What holds in all tetrahedra but those left out. Faces and tetrahedra that are not listed hold
/// no point that is degenerate of the kind; both lists ascend.
struct CurveTopology {
  std::vector<CurveFace> faces;
  std::vector<CurveTet> tets;
  /// Faces and tetrahedra settled by doubles with an error bound, and by integers.
  std::uint64_t by_balls = 0, by_integers = 0;

  const CurveFace* face(const std::array<Vertex, 3>& vertices) const;
};

/// @param left_out tetrahedra of which nothing is asked
CurveTopology derive_curves(const Input& input, const Field& field, Kind kind,
                            const std::vector<bool>& left_out, const Progress& progress);

}  // namespace certificate
