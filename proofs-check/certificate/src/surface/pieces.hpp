// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The triangles of a level, piece by piece.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_set>

#include "claims/half_edges.hpp"
#include "surface/compare_surface.hpp"
#include "surface/cones.hpp"

namespace certificate {

/// The pieces of the triangles in each tetrahedron, against its claimed sheets. Its members throw
/// Wrong.
class Pieces {
 public:
  using Chain = std::vector<Number>;  ///< vertices along an arc, or around a closed curve
  using Face = std::array<Vertex, 3>;
  static constexpr std::size_t kNone = HalfEdges::kNone;

  Pieces(const LevelCase& c, const CrossingVertices& vertices, const HalfEdges& mesh)
      : c_(c), vertices_(vertices), mesh_(mesh) {}

  void compare();
  PlacedSurface place() &&;

 private:
  bool is_end(Number v) const { return vertices_.crossing.contains(v) || apexes_.contains(v); }
  /// Where the mesh in a tetrahedron runs along a curve of one of its faces.
  struct FaceChain {
    Face face;
    std::size_t tet;
    Chain chain;
  };
  /// What is found in a tetrahedron.
  struct Found {
    std::string wrong;  ///< empty if it is as claimed
    std::vector<FaceChain> chains;
    std::vector<std::pair<Number, std::vector<BoundaryEdge>>> folds;  ///< by crossing
    std::vector<std::vector<ClosedLoop>> closed_sheets;
    std::vector<ClosedLoop> closed_curves;
    std::vector<ClosedPiece> closed_pieces;
  };

  void group();
  std::span<const std::size_t> triangles_in(std::size_t tet) const;
  std::span<const std::pair<Face, std::size_t>> tets_at(const Face& face) const;
  void note_apexes();
  std::size_t compare_all(const Json& claims, bool are_cones);
  void take(std::size_t tet, Found&& found);
  void compare_sheets(const Json& claim, const ConeTopology* cone, Found& found) const;
  void compare(std::size_t tet, const Json& claim, std::vector<Piece>& pieces, Found& found) const;
  std::vector<ClosedLoop> compare(std::size_t tet, const Json& claim,
                                  std::vector<BoundaryEdge>& loop, Found& found) const;
  void add_chain(std::size_t tet, const Json& opposite, std::span<const BoundaryEdge> edges,
                 bool closed, Found& found) const;
  void compare_chains() const;
  void compare_folds() const;
  void compare_fans() const;
  void note_places(PlacedSurface& result) const;

  const LevelCase& c_;
  const CrossingVertices& vertices_;
  const HalfEdges& mesh_;
  std::vector<std::size_t> tets_;  ///< of each triangle
  std::vector<std::size_t> by_tet_;        ///< the triangles, by their tetrahedra
  std::vector<std::size_t> held_;          ///< tetrahedra that hold triangles, ascending
  std::vector<std::size_t> first_;         ///< of each, where its triangles begin; and the end
  std::vector<std::pair<Face, std::size_t>> tets_at_;  ///< that are crossed or left out, by face
  std::vector<FaceChain> chains_;          ///< by face and tetrahedron
  std::unordered_set<Number> apexes_;  ///< tips, and vertices halfway between two
  /// Where sheets end at an edge between two tips, by tetrahedron and crossing.
  std::map<std::pair<std::size_t, Number>, std::vector<BoundaryEdge>> folds_;
  std::vector<std::pair<std::size_t, std::vector<ClosedLoop>>> closed_sheets_;
  std::vector<std::pair<std::size_t, ClosedLoop>> closed_curves_;
  std::map<std::size_t, std::vector<ClosedPiece>> closed_pieces_;
};

}  // namespace certificate
