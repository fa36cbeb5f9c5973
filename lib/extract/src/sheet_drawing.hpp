// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "chart_triangulation.hpp"
#include "inner_vertices.hpp"

namespace tensortopo {

/// The sheets of one tetrahedron, triangulated in a plane chart of the surface.
template <class Scalar>
class SheetDrawing {
 public:
  SheetDrawing(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
               const TetPlan<Scalar>& plan, const FaceArcVertices& vertices,
               const Level<Scalar>& level, TetTriangles<Scalar>& out);
  virtual ~SheetDrawing() = default;

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

  /// The image of a new vertex of the level inside the tetrahedron, at this place; nothing if there
  /// is none.
  virtual std::optional<std::size_t> add_inner_image(const Vector3<double>& along) = 0;

  /// Images of new vertices of the level inside the tetrahedron, clear of the rims; their points.
  virtual std::vector<ChartTriangulation::Point> grid_samples(
      const ChartTriangulation::Clearance& clearance) = 0;

  /// The regions that the segments bound, with samples of a grid in them.
  bool triangulate();

  /// A diagonal between two rim vertices on one face might be chosen by the neighbour as well, and
  /// a triangle with three of them lies in the face: puts a vertex on every such diagonal.
  bool split_diagonals();

  /// A rim of three vertices on one face would leave a triangle in that face, which the neighbour
  /// across it might draw as well: puts a vertex amid it.
  bool raise_flat_triangles();

  /// Gives the triangles the direction that their rims have, checks them against the plan and
  /// exchanges diagonals.
  bool emit();

  const TetWithCurves<Scalar>& tet_;
  const TetPlan<Scalar>& plan_;
  const Level<Scalar>& level_;
  TetTriangles<Scalar>& out_;
  InnerVertices<Scalar> inner_;
  std::vector<std::vector<RimVertex>> rims_;
  std::vector<Image> images_;
  std::vector<ChartTriangulation::Point> points_;  ///< of the images, in the chart
  std::vector<std::array<std::size_t, 2>> segments_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace tensortopo
