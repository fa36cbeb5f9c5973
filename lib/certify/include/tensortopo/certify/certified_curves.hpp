// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo {

/// A degenerate point inside a face, with a box that holds it and no other of its kind.
struct FacePointClaim {
  CurveMesh::Index vertex = -1;  ///< of the polylines
  /// Its barycentric coordinates at the face's second and third vertex, the face's vertices being
  /// in ascending order, are at most 2^-depth from place / 2^depth.
  std::array<std::uint64_t, 2> place{};
  int depth = 0;  ///< how often the unit interval is halved
};

/// Everything that a certificate claims about the degenerate curves of one kind: see proofs-check's
/// description of the file for what each claim means.
struct CertifiedCurves {
  /// A face of the mesh and the degenerate points inside it.
  struct Face {
    std::array<TetMesh::Index, 3> vertices{};  ///< ascending
    std::vector<FacePointClaim> points;        ///< by vertex
  };
  /// A tetrahedron and the pieces of curves inside it.
  struct Tet {
    TetMesh::Index tet = -1;  ///< position in the mesh
    /// The vertices that a piece of the curve joins, ascending; in order.
    std::vector<std::array<CurveMesh::Index, 2>> pieces;
  };
  /// A connected component of the polylines.
  struct Curve {
    bool closed = false;                 ///< no vertex is the end of one line only
    std::size_t lines = 0;               ///< how many the component has
    CurveMesh::Index first_vertex = -1;  ///< the smallest
  };

  Degeneracy kind = Degeneracy::linear;  ///< linear (mode 1) or planar (mode -1)
  /// Numbers of the polylines.
  std::size_t vertices = 0, lines = 0;
  std::vector<UndecidedCell> undecided;  ///< ascending; special positions among them
  std::vector<Face> faces;               ///< with points, of all other tetrahedra; ascending
  std::vector<Tet> tets;                 ///< with pieces; ascending
  std::vector<Curve> curves;             ///< by first vertex
  std::optional<StabilityClaim> stability;  ///< of an uncertain field

  /// Of curves put together from pieces: the ids of vertices and tetrahedra of the mesh, in the whole
  /// mesh, ascending; the file then names these. Empty: it has the numbers of the vertices, and the
  /// mesh's own `cell_ids`.
  std::vector<std::int64_t> vertex_ids, cell_ids;

  /// The faces, as indices into `faces`, that `stability` claims to have their points in all fields;
  /// ascending.
  std::vector<std::size_t> claimed_crossings() const;

  /// Entities claimed: faces and tetrahedra that the curves meet, components, stable ones, that there
  /// are no others, and that faces have their points in all fields.
  std::size_t claims() const {
    return faces.size() + tets.size() + curves.size() + 1 +
           (stability ? stability->components.size() : 0) +
           (claimed_crossings().empty() ? 0 : 1);
  }
};

/// The claims that an extraction supports: those of general position, its special positions being
/// left undecided, each with its name. The points of faces are found again, with bounds.
/// @param extraction  of this kind, made of `mesh`
CertifiedCurves certify(const TetMesh& mesh, Degeneracy kind, const CurveExtraction& extraction);

}  // namespace tensortopo
