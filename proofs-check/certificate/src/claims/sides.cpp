// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/sides.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "face_level.hpp"

namespace certificate {
namespace {

/// Whole numbers in proportion to the barycentric coordinates of a refinement's point, and its side.
/// @param vertices  of the mesh, the refinement's roots
std::string text_of(const LevelCase& c, std::span<const Vertex> vertices,
                    const Refinement::Point& point) {
  // Weights are those of the exact tensors, each of which is a multiple of the vertex' own.
  long largest = c.field.exponent(vertices[0]);
  for (const Vertex v : vertices) largest = std::max(largest, c.field.exponent(v));
  std::vector<mpz_class> weights;
  mpz_class common = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    weights.push_back(point.weights[i]
                      << static_cast<unsigned long>(largest - c.field.exponent(vertices[i])));
    common = gcd(common, weights.back());
  }
  std::string text;
  for (const mpz_class& w : weights)
    text += (text.empty() ? "[" : ",") + mpz_class(w / common).get_str();
  return text + (point.above ? "] above" : "] below");
}

std::string name_of(std::span<const Vertex> vertices) {
  return "at weights of the vertices " + Json(std::vector<Vertex>(vertices.begin(), vertices.end())).dump() + ": ";
}

/// Which points to show.
std::vector<Refinement::Id> chosen(const Refinement& r) {
  std::vector<Refinement::Id> result;
  const auto& points = r.points();
  if (r.corners() == 2) {
    for (const Refinement::Id p : points_along(r, 0, 1))
      if (p < 2 || points[p].above != points[result.back()].above) result.push_back(p);
    return result;
  }
  for (Refinement::Id p = 0; p < r.corners(); ++p) result.push_back(p);
  if (std::any_of(result.begin(), result.end(),
                  [&](Refinement::Id p) { return points[p].above != points[0].above; }))
    return result;
  for (auto p = static_cast<Refinement::Id>(r.corners()); p < points.size(); ++p)
    if (points[p].above != points[0].above) {
      result.push_back(p);
      break;
    }
  return result;
}

}  // namespace

std::string sides_in(const LevelCase& c, std::span<const Number> numbers) {
  bool is_there = false, is_asked = false;
  for (std::size_t t = 0; t < c.input.tets.size(); ++t) {
    const auto& tet = c.input.tets[t];
    const bool has_all = std::all_of(numbers.begin(), numbers.end(), [&](Number v) {
      return std::find(tet.begin(), tet.end(), v) != tet.end();
    });
    is_there = is_there || has_all, is_asked = is_asked || (has_all && !c.left_out[t]);
  }
  if (!is_there) return "no tetrahedron of the input has these vertices";
  if (!is_asked) return "all tetrahedra with these vertices are left out";
  std::vector<Vertex> vertices;
  std::vector<Corner> corners;
  for (const Number v : numbers) {
    vertices.push_back(static_cast<Vertex>(v));
    if (c.field.is_zero(vertices.back()))
      return "the level's quantity is undefined at vertex " + std::to_string(v);
    corners.push_back(c.field.corner(vertices.back(), c.topology.above[v]));
  }
  Refinement refinement(c.level, corners);
  refinement.run();
  std::string text;
  for (const Refinement::Id p : chosen(refinement))
    text += (text.empty() ? name_of(vertices) : ", ") +
            text_of(c, vertices, refinement.points()[p]);
  return text;
}

std::string sides_of_curves(const LevelCase& c, const FaceTopology& face) {
  std::string text;
  for (const auto& curve : face.level.loops)
    for (const Refinement::Id p : curve.front())
      text += (text.empty() ? "beside closed curves, " + name_of(face.vertices) : ", ") +
              text_of(c, face.vertices, face.level.refinement->points()[p]);
  return text;
}

}  // namespace certificate
