// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "extract/curves/curve_assembly.hpp"
#include "extract/curves/special/special_cell.hpp"
#include "tensortopo/extract/meshing_message.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// What is known of the curves' cells, in the course of the extraction.
struct CurveCells {
  TetComplex complex;
  std::vector<FacePoints> faces;  ///< of the complex; points of one kind only
  std::vector<CurvePlace> places;
  /// Of each face: where its points begin in `places`.
  std::vector<std::size_t> first_place;
};

/// What a tetrahedron holds.
struct CellCurves {
  std::vector<CurvePlace> places;  ///< in its interior
  /// Ends are positions in `CurveCells::places`, or behind these in `places`.
  std::vector<CurveLink> links;
  std::optional<CurveObstacle> obstacle;
  /// With an obstacle: the eigenvector whose curve is found all the same.
  std::optional<Vector3<double>> axis;
};

/// The vertices, edges and faces at which a curve is in special position: what is there is found
/// once, exactly, and shared by all cells around.
class SpecialPositions {
 public:
  SpecialPositions(const TetMesh& mesh, const ScaledField<double>& field, Degeneracy kind,
                   const ExtractOptions& options, CurveCells& cells);

  /// Looks at the faces with an obstacle, their edges and vertices, and at vertices without
  /// deviator. Adds the points found to the places, behind those that are there.
  void find();

  bool is_special(TetMesh::Index face) const { return faces_.contains(face); }

  /// What a tetrahedron of the complex holds.
  CellCurves curve_in_tet(std::size_t tet) const;

  /// What edges and faces hold.
  struct LinesBelow {
    /// The pieces that run along edges and in faces, but for those that bound surfaces.
    std::vector<CurveLink> links;
    /// What the tetrahedra around each edge and face with such pieces tell each other: their
    /// obstacles and axes, on which it depends what becomes of the pieces. Ascending, by
    /// tetrahedra of the mesh.
    std::vector<MeshingMessage> messages;
  };

  /// @param tets  of the complex
  LinesBelow lines_below(const std::vector<CellCurves>& tets) const;

 private:
  using Index = TetMesh::Index;

  /// The points found in a simplex, and its pieces.
  struct Found {
    SpecialCell cell;
    std::vector<std::size_t> boundary;  ///< places, as the ends of pieces count them
  };
  struct Loop {
    std::vector<SpecialPoint> points;
    std::vector<std::size_t> places;
  };

  /// An edge or face with pieces, and the tetrahedra of the complex around it.
  struct Below {
    const Found* found;
    SimplexVertices vertices;
    std::vector<std::size_t> around;  ///< ascending
  };

  /// Faces, then edges.
  std::vector<Below> simplices_below() const;
  std::vector<CurveLink> links_of(std::span<const Below> simplices,
                                  const std::vector<CellCurves>& tets) const;
  std::vector<MeshingMessage> messages_of(std::span<const Below> simplices,
                                          const std::vector<CellCurves>& tets) const;
  void find_on_vertices();
  void find_on_edges();
  void find_on_faces();
  template <std::size_t Count>
  std::array<ScaledTensor, Count> tensors_at(const std::array<Index, Count>& vertices) const;
  template <std::size_t Count>
  void add_to(Loop& boundary, std::size_t place, const std::array<Index, Count>& vertices) const;
  template <std::size_t Count>
  void add_vertices(Loop& boundary, const std::array<Index, Count>& vertices) const;
  /// Enters the points of a simplex among the places.
  template <std::size_t Count>
  void enter(Found& found, const std::array<Index, Count>& vertices);
  /// Of tetrahedra of the complex, in order: where the curve crosses itself.
  using TetCrossings = std::vector<std::pair<Index, Vector3<Rational>>>;

  /// @param crossings  of the curves in the tetrahedra beside it
  Found found_on_face(Index face, std::span<const ExactDirection> crossings) const;
  /// Of the tetrahedra at some of the faces.
  TetCrossings crossings_beside(std::span<const Index> faces,
                                std::span<const std::size_t> crossed) const;
  /// Where the curves in the tetrahedra at a face cross themselves.
  std::vector<ExactDirection> crossings_at(Index face, const TetCrossings& crossings) const;
  ExactDirection direction_of(std::size_t place) const;

  const TetMesh& mesh_;
  const ScaledField<double>& field_;
  const bool linear_;
  const ExtractOptions& options_;
  CurveCells& cells_;
  std::size_t first_special_ = 0;  ///< place
  /// Of the places from there on; none isotropic.
  std::vector<std::optional<ExactDirection>> directions_;
  std::vector<std::size_t> general_face_;  ///< of the places before
  std::map<Index, std::size_t> vertices_;  ///< places
  std::map<Index, Found> edges_, faces_;   ///< of the complex
};

}  // namespace tensortopo
