// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_check_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/oracles/high_precision_mode.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {

namespace {

// Corners of the face opposite corner i, in order.
std::array<TetMesh::Index, 3> face_opposite(const std::array<TetMesh::Index, 4>& tet,
                                            std::size_t i) {
  std::array<TetMesh::Index, 3> face{tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]};
  std::sort(face.begin(), face.end());
  return face;
}

// A point computed in doubles may be off by some roundings.
constexpr double roundings = 16, negligible = 1e-40;

bool is_finite(const Vector3<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::vector<std::string> Complaints::take() {
  for (const auto& [kind, count] : count_) {
    if (count <= spelled_out_) continue;
    texts_.push_back(kind + ": " + std::to_string(count) + " in all");
  }
  return std::move(texts_);
}

BoundaryOracle::BoundaryOracle(const SurfaceMesh& surface, const TetMesh& mesh,
                               const SurfaceCheckOptions& options)
    : surface_(surface), mesh_(mesh), options_(options) {
  if (options.on_domain_boundary) return;
  for (const auto& tet : mesh.tets) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto face = face_opposite(tet, i);
      if (!boundary_faces_.insert(face).second) boundary_faces_.erase(face);
    }
  }
}

bool BoundaryOracle::operator()(SurfaceMesh::Index u, SurfaceMesh::Index v,
                                TetMesh::Index tet) const {
  if (options_.on_domain_boundary) return options_.on_domain_boundary(u, v);
  const PreciseMode first = precise_mode(mesh_, tet, surface_.points[as_size(u)], 0),
                    second = precise_mode(mesh_, tet, surface_.points[as_size(v)], 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const double slack = roundings * first.barycentric_rounding[i] + negligible;
    if (std::abs(first.barycentric[i]) <= slack && std::abs(second.barycentric[i]) <= slack &&
        boundary_faces_.contains(face_opposite(mesh_.tets[as_size(tet)], i))) {
      return true;
    }
  }
  return false;
}

bool has_no_mode(const SurfaceMesh& surface, const TetMesh& mesh, std::size_t vertex) {
  if (surface.carrier_vertices.size() != surface.points.size()) return false;
  for (const auto k : surface.carrier_vertices[vertex]) {
    if (k < 0) continue;
    const auto& t = mesh.tensors[as_size(k)];
    if (t.xx != t.yy || t.yy != t.zz || t.xy != 0 || t.yz != 0 || t.xz != 0) return false;
  }
  return surface.carrier_vertices[vertex][0] >= 0;
}

bool check_finite(const SurfaceMesh& surface, const TetMesh& mesh, Complaints& complaints) {
  bool usable = true;
  const std::array<std::pair<const char*, const std::vector<Vector3<double>>*>, 3> directions{
      {{"medium eigenvector", &surface.medium_eigenvector},
       {"dominant eigenvector", &surface.dominant_eigenvector},
       {"normal", &surface.normal}}};
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (!is_finite(surface.points[v])) {
      complaints.add("not finite", "the point of vertex ", v);
      usable = false;
    }
    for (const auto& [name, values] : directions) {
      const auto& direction = (*values)[v];
      const double length = std::sqrt(dot(direction, direction));
      if (has_no_mode(surface, mesh, v) && (length == 0 || values == &surface.normal)) {
        if (length == 0 || std::abs(length - 1) < 1e-9) continue;
      }
      if (!(std::abs(length - 1) < 1e-9)) {
        complaints.add("not a unit vector", "the ", name, " of vertex ", v, " has length ", length);
      }
    }
  }
  return usable;
}

void check_normals(const SurfaceMesh& surface, const SurfaceCheckOptions& options,
                   Complaints& complaints, SurfaceReport& report) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    const Vector3<double>& origin = surface.points[as_size(corners[0])];
    const Vector3<double> normal = cross(surface.points[as_size(corners[1])] - origin,
                                         surface.points[as_size(corners[2])] - origin);
    for (const auto v : corners) {
      if (dot(normal, surface.normal[as_size(v)]) > 0) continue;
      ++report.opposed_normals;
      if (options.opposed_normals_are_violations) {
        complaints.add("opposed normal", "triangle ", t, " is turned against the normal of vertex ",
                       v);
      }
    }
  }
}

void check_modes(const SurfaceMesh& surface, const TetMesh& mesh,
                 const SurfaceCheckOptions& options, Complaints& complaints,
                 SurfaceReport& report) {
  std::vector<std::pair<SurfaceMesh::Index, TetMesh::Index>> places;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const auto v : surface.triangles[t])
      if (!has_no_mode(surface, mesh, as_size(v))) places.emplace_back(v, surface.tet[t]);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  ResidualReport& residuals = report.residuals;
  for (const auto& [v, tet] : places) {
    const PreciseMode precise =
        precise_mode(mesh, tet, surface.points[as_size(v)], surface.mode[as_size(v)]);
    const double residual = std::abs(precise.residual);
    ++residuals.evaluated;
    if (!(residual <= residuals.largest)) residuals.largest = residual;
    if (!(residual <= options.residual_tolerance)) {
      ++residuals.above;
      const double ratio = residual / precise.rounding;
      residuals.worst_ratio = std::max(residuals.worst_ratio, ratio);
      // The derivative is that at the rounded point; a thousandth covers the difference.
      if (ratio <= 1.001) {
        ++residuals.explained;
      } else {
        complaints.add("residual", "vertex ", v, " in tetrahedron ", tet, " has residual ",
                       precise.residual, ", of which rounding its coordinates explains ",
                       precise.rounding, "; it lies at ", exact_text(surface.points[as_size(v)].x),
                       ' ', exact_text(surface.points[as_size(v)].y), ' ',
                       exact_text(surface.points[as_size(v)].z));
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double slack = roundings * precise.barycentric_rounding[i] + negligible;
      if (precise.barycentric[i] < -slack) {
        complaints.add("outside", "vertex ", v, " has barycentric coordinate ",
                       precise.barycentric[i], " in tetrahedron ", tet, " of a triangle at it");
      }
    }
  }
}

}  // namespace tensortopo::test
