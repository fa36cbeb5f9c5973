// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/meshing_message.hpp"

namespace tensortopo {

/// The kinds of vertices of curves, in the order in which an extraction numbers them.
enum class CurveVertexKind : std::uint8_t {
  general,       ///< an end of lines in a face in general position
  on_vertex,     ///< an end at a vertex of the mesh
  on_edge,       ///< an end in an edge
  on_face,       ///< an end in a face in special position
  in_tet,        ///< an end in a tetrahedron
  between_ends,  ///< no end: inside of one line
};

/// Names for the vertices and lines of curves: the same in each mesh that has the tetrahedra
/// around.
///
/// Vertices are numbered by kind, those of one kind by the canonical order of their carriers (see
/// `CanonicalMesh`), those of one carrier by ordinal; those between ends in the order of the lines'
/// keys: tetrahedra, faces, edges, each in canonical order, and by ordinal.
struct CurveKeys {
  /// Of a vertex.
  struct Vertex {
    CurveVertexKind kind = CurveVertexKind::general;  ///< what it is
    /// Of an end: which one it is in its carrier. Else: how many are before it in its line, as the
    /// line's cell gives it.
    std::int32_t ordinal = 0;
  };
  /// Of a line.
  struct Line {
    /// The vertices of the cell whose interior holds it, ascending; -1 fills up.
    std::array<TetMesh::Index, 4> cell{-1, -1, -1, -1};
    std::int32_t ordinal = 0;  ///< which one it is in the cell
    bool is_reversed = false;  ///< whether it runs against the direction in which the cell gives it
  };

  std::vector<Vertex> vertices;  ///< of each vertex
  std::vector<Line> lines;       ///< of each line
  /// What tetrahedra around an edge or face with lines tell each other: whether degenerate points
  /// fill more than curves in them. `pass` and `round` are 0.
  std::vector<MeshingMessage> messages;
};

/// Curves with their keys.
struct KeyedCurves {
  CurveExtraction extraction;  ///< as `extract_degenerate_curves` gives it
  CurveKeys keys;              ///< in numbers of the mesh
};

/// As `extract_degenerate_curves`.
KeyedCurves extract_keyed_curves(const TetMesh& mesh, Degeneracy kind,
                                 const ExtractOptions& options = {});

}  // namespace tensortopo
