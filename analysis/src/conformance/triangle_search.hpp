// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Searches among the triangles of a surface, by VTK's cell locator. The surface must live on, and
/// have a triangle.
class TriangleSearch {
 public:
  explicit TriangleSearch(const SurfaceMesh& surface);
  ~TriangleSearch();

  struct Nearest {
    SurfaceMesh::Index triangle = -1;
    double distance = 0;
  };
  Nearest nearest(const Vector3<double>& p) const;

  /// Triangles whose boxes meet this one, ascending.
  std::vector<SurfaceMesh::Index> near_box(const Vector3<double>& low,
                                           const Vector3<double>& high) const;

 private:
  struct Locator;
  std::unique_ptr<Locator> locator_;
};

/// The distance of a point from a triangle.
double distance_to_triangle(const Vector3<double>& p, const Vector3<double>& a,
                            const Vector3<double>& b, const Vector3<double>& c);

}  // namespace tensortopo
