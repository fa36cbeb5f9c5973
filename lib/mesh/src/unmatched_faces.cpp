// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/unmatched_faces.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

#include "orientation.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/box_tree.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {
namespace {

using Corners = std::array<Vector3<double>, 3>;

/// A face with its normal and the product of two of its edges' lengths, in doubles.
struct FaceInSpace {
  Corners corners;
  Vector3<double> normal;
  double size;
};

FaceInSpace face_of(const TetMesh& mesh, const OuterFace& outer) {
  FaceInSpace face;
  for (std::size_t i = 0; i < 3; ++i) face.corners[i] = mesh.points[as_size(outer.vertices[i])];
  const auto u = face.corners[1] - face.corners[0], v = face.corners[2] - face.corners[0];
  face.normal = cross(u, v);
  face.size = max_norm(u) * max_norm(v);
  return face;
}

/// Whether normals are surely not opposite to each other: their product would be negative. A normal
/// is off by less than 10 units of rounding by the size, so the product by less than 180.
bool cannot_be_opposite(const FaceInSpace& f, const FaceInSpace& g) {
  return dot(f.normal, g.normal) > 1e-13 * f.size * g.size;
}

bool are_in_one_plane(const Corners& f, const Corners& g) {
  return std::all_of(g.begin(), g.end(),
                     [&](const auto& p) { return detail::orientation(f[0], f[1], f[2], p) == 0; });
}

/// The turn of three points as seen along an axis; exact.
int turn(const Vector3<double>& p, const Vector3<double>& q, const Vector3<double>& r, int axis) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto flat = [axis](const Vector3<double>& v) {
    return axis == 0 ? Point(v.y, v.z) : axis == 1 ? Point(v.z, v.x) : Point(v.x, v.y);
  };
  return static_cast<int>(CGAL::orientation(flat(p), flat(q), flat(r)));
}

/// Whether the line through an edge of f has all of f on one side and all of g on the other.
bool has_separating_edge(const Corners& f, const Corners& g, int axis) {
  const int inside = turn(f[0], f[1], f[2], axis);
  for (std::size_t i = 0; i < 3; ++i)
    if (std::all_of(g.begin(), g.end(), [&](const auto& p) {
          return inside * turn(f[i], f[(i + 1) % 3], p, axis) <= 0;
        }))
      return true;
  return false;
}

/// Of faces in one plane: whether their tetrahedra are on different sides and they overlap.
bool lie_on_each_other(const Corners& f, const Corners& g) {
  int axis = 0;
  while (turn(f[0], f[1], f[2], axis) == 0) ++axis;  // one sees the face, which has an area
  return turn(f[0], f[1], f[2], axis) == -turn(g[0], g[1], g[2], axis) &&
         !has_separating_edge(f, g, axis) && !has_separating_edge(g, f, axis);
}

}  // namespace

std::vector<std::array<std::size_t, 2>> unmatched_faces(const TetMesh& mesh,
                                                        std::span<const OuterFace> outer) {
  std::vector<FaceInSpace> faces;
  std::vector<AxisBox> boxes;
  faces.reserve(outer.size());
  boxes.reserve(outer.size());
  for (const OuterFace& o : outer) {
    faces.push_back(face_of(mesh, o));
    boxes.push_back(box_of(faces.back().corners));
  }
  const BoxTree tree(boxes);
  std::mutex mutex;
  std::vector<std::array<std::size_t, 2>> pairs;
  const auto look = [&](std::size_t a, std::size_t b) {
    const FaceInSpace &f = faces[a], &g = faces[b];
    if (cannot_be_opposite(f, g) || !are_in_one_plane(f.corners, g.corners)) return false;
    if (lie_on_each_other(f.corners, g.corners)) {
      const std::lock_guard lock(mutex);
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
    return false;
  };
  constexpr std::size_t kPart = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size(), kPart), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t rank = range.begin(); rank < range.end(); ++rank) tree.any_meeting(rank, look);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace tensortopo
