// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/patch/charts/chart_triangulation.hpp"
#include "extract/patch/charts/inner_vertices.hpp"

namespace tensortopo {

/// The sheets of one tetrahedron, triangulated in a plane chart of the surface.
template <class Scalar>
class ChartMesher {
 public:
  ChartMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
              const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
              const Level<Scalar>& level, int defect_rounds, Patch<Scalar>& out);
  virtual ~ChartMesher() = default;

 protected:
  /// A corner of the output and a vector that stands for its place: sums of such vectors, with
  /// positive factors, stand for places between.
  struct Image {
    std::int32_t corner;
    std::uint8_t faces;
    Vector3<double> v;
  };

  std::size_t add_image(std::int32_t corner, std::uint8_t faces, const Vector3<double>& v,
                        const ChartTriangulation::Point& point) {
    images_.push_back({corner, faces, v});
    points_.push_back(point);
    return images_.size() - 1;
  }

  /// The places of the images in space.
  std::span<const Vector3<double>> places_in_space();

  /// The image of a new vertex of the level inside the tetrahedron, at this place; nothing if there
  /// is none.
  virtual std::optional<std::size_t> add_inner_image(const Vector3<double>& along) = 0;

  /// Images of new vertices of the level inside the tetrahedron, clear of the boundary loops; their
  /// points.
  virtual std::vector<ChartTriangulation::Point> grid_samples(
      const ChartTriangulation::Clearance& clearance) = 0;

  /// The regions that the segments bound, with samples of a grid in them, and more where triangles
  /// would not be embedded in space.
  bool triangulate();

  /// A diagonal between two boundary loop vertices on one face might be chosen by the neighbour as
  /// well, and a triangle with three of them lies in the face: puts a vertex on every such
  /// diagonal.
  bool split_diagonals();

  /// A boundary loop of three vertices on one face would leave a triangle in that face, which the
  /// neighbour across it might mesh as well: puts a vertex amid it.
  bool raise_flat_triangles();

  /// Gives the triangles the direction that their boundary loops have, and checks them against the
  /// proved topology. Exchanges diagonals, unless vertices were added at defects.
  bool emit();

  const TetWithCurves<Scalar>& tet_;
  const CellTopology<Scalar>& proved_;
  const Level<Scalar>& level_;
  int defect_rounds_;
  Patch<Scalar>& out_;
  InnerVertices<Scalar> inner_;
  std::vector<std::vector<BoundaryVertex>> boundaries_;
  std::vector<Image> images_;
  std::vector<ChartTriangulation::Point> points_;  ///< of the images, in the chart
  std::vector<Vector3<double>> places_in_space_;   ///< of the first images
  std::vector<std::array<std::size_t, 2>> segments_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace tensortopo
