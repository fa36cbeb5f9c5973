// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "extract/level/level_in_tet.hpp"
#include "extract/level/position.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/cone_points.hpp"
#include "extract/surface/cone_sheets.hpp"
#include "extract/surface/pipeline.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {

/// Puts the sheets together. Keys became numbers in `number_vertices`; what is left is to number
/// the vertices inside tetrahedra, drop what nothing uses, and say what is known at each vertex.
template <class Scalar>
Extraction Pipeline<Scalar>::assemble() {
  Extraction result;
  SurfaceMesh& surface = result.surface;
  for (std::size_t t = 0; t < tets_.size(); ++t)
    if (tets_[t].unresolved) {
      tets_[t].patch = {};
      result.unresolved.push_back({complex_.tets[t], *tets_[t].unresolved});
    }

  // Output ids: used edge vertices, used face vertices (those of faces that got more samples
  // last), inner vertices, copies of edge vertices.
  const auto boundary_count = boundary_position_.size();
  std::vector<Index> new_id(boundary_count, -1);
  std::size_t triangle_count = 0;
  for (const auto& state : tets_) {
    triangle_count += state.patch.triangles.size();
    for (const auto& triangle : state.patch.triangles)
      for (const auto corner : triangle)
        if (corner >= 0) new_id[as_size(corner)] = 0;
  }
  Index next = 0;
  for (auto& id : new_id)
    if (id == 0) id = next++;
  const auto boundary_used = next;
  const CrossingCopies copies = crossing_copies();
  if (options_.keep_topology) result.topology = topology(new_id);
  std::vector<Index> inner_first(tets_.size() + 1, boundary_used);
  for (std::size_t t = 0; t < tets_.size(); ++t)
    inner_first[t + 1] = inner_first[t] + static_cast<Index>(tets_[t].patch.inner.size());
  const auto count = as_size(inner_first.back()) + copies.original.size();

  surface.points.resize(count);
  surface.carrier.resize(count);
  surface.carrier_id.resize(count);
  surface.carrier_vertices.resize(count);
  surface.medium_eigenvector.resize(count);
  surface.dominant_eigenvector.resize(count);
  surface.triangles.reserve(triangle_count);
  surface.tet.reserve(triangle_count);

  const auto carry = [&](Index v, std::size_t simplex, std::span<const Index> vertices,
                         Carrier carrier) {
    const auto id = new_id[as_size(v)];
    if (id < 0) return;
    surface.carrier[as_size(id)] = carrier;
    surface.carrier_id[as_size(id)] = static_cast<Index>(simplex);
    surface.carrier_vertices[as_size(id)] = {-1, -1, -1, -1};
    std::copy(vertices.begin(), vertices.end(), surface.carrier_vertices[as_size(id)].begin());
    surface.points[as_size(id)] = boundary_position_[as_size(v)];
    surface.medium_eigenvector[as_size(id)] = boundary_medium_[as_size(v)];
  };
  for (std::size_t e = 0; e < complex_.edges.size(); ++e)
    if (crossings_[e])
      for (std::size_t k = 0; k < crossings_[e]->size(); ++k)
        carry(edge_vertex_[e] + static_cast<Index>(k), e, complex_.edges[e], Carrier::edge);
  for (std::size_t f = 0; f < complex_.faces.size(); ++f)
    if (arcs_[f]) {
      auto v = face_vertex_[f];
      for (const auto& arc : *arcs_[f])
        for (std::size_t k = 0; k < arc.samples.size(); ++k)
          carry(v++, f, complex_.faces[f], Carrier::face);
    }
  for (std::size_t k = 0; k < copies.original.size(); ++k) {
    const auto original = new_id[as_size(copies.original[k])];
    const auto id = inner_first.back() + static_cast<Index>(k);
    const auto from = as_size(original), to = as_size(id);
    surface.carrier[to] = surface.carrier[from];
    surface.carrier_id[to] = surface.carrier_id[from];
    surface.carrier_vertices[to] = surface.carrier_vertices[from];
    surface.points[to] = surface.points[from];
    surface.medium_eigenvector[to] = surface.medium_eigenvector[from];
    if (options_.keep_topology) result.topology.copies.push_back({original, id});
  }
  std::vector<char> is_apex(count, 0);
  for (std::size_t v = 0; v < zero_vertex_.size(); ++v) {
    if (zero_vertex_[v] < 0 || new_id[as_size(zero_vertex_[v])] < 0) continue;
    carry(zero_vertex_[v], v, std::array{static_cast<Index>(v)}, Carrier::vertex);
    is_apex[as_size(new_id[as_size(zero_vertex_[v])])] = 1;
  }

  parallel_stage(options_, "stitch", tets_.size(), 256, [&](std::size_t t) {
    const auto& inner = tets_[t].patch.inner;
    if (inner.empty()) return;
    const auto& v = mesh_.tets[as_size(complex_.tets[t])];
    std::array<int, 4> exponents;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      exponents[i] = field_.exponents[as_size(v[i])];
      points[i] = mesh_.points[as_size(v[i])];
    }
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const auto id = as_size(inner_first[t]) + k;
      surface.carrier[id] = Carrier::tet;
      surface.carrier_id[id] = complex_.tets[t];
      surface.carrier_vertices[id] = v;
      std::sort(surface.carrier_vertices[id].begin(), surface.carrier_vertices[id].end());
      surface.points[id] = position_at(inner[k].weights, exponents, points);
      surface.medium_eigenvector[id] =
          vector_cast<double>(medium_eigenvector(inner[k].tensor, level_));
    }
  });

  for (std::size_t t = 0; t < tets_.size(); ++t) {
    const auto& patch = tets_[t].patch;
    if (patch.triangles.empty()) continue;
    ++statistics_.tets_crossed;
    for (const auto& triangle : patch.triangles) {
      std::array<Index, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] =
            triangle[i] >= 0 ? new_id[as_size(triangle[i])] : inner_first[t] + (-1 - triangle[i]);
        if (const auto copy = copies.of.find({t, triangle[i]}); copy != copies.of.end())
          corners[i] = inner_first.back() + static_cast<Index>(copy->second);
      }
      surface.triangles.push_back(corners);
      surface.tet.push_back(complex_.tets[t]);
    }
  }

  add_cone_points(surface, is_apex);
  if (options_.keep_topology)
    result.topology.cones = cone_sheets(surface, is_apex, result.topology.copies);
  count_sheets();
  release_stages();
  describe_vertices(surface, is_apex);
  surface.component = surface_components(surface);
  return result;
}

template <class Scalar>
void Pipeline<Scalar>::count_sheets() {
  const auto sheets_meshed = [&](Method method) -> std::size_t& {
    switch (method) {
      case Method::tubes:
        return statistics_.sheets_tubes;
      case Method::small_disc:
        return statistics_.sheets_small;
      case Method::graph:
        return statistics_.sheets_graph;
      case Method::manifold:
        return statistics_.sheets_manifold;
      case Method::dominant:
        return statistics_.sheets_dominant;
      case Method::boundaries:
        return statistics_.sheets_rims;
      case Method::cone:
        return statistics_.sheets_cones;
      case Method::subdivision:
      case Method::fan:
        break;
    }
    return statistics_.sheets_leaves;
  };
  for (const auto& state : tets_) {
    if (state.patch.triangles.empty()) continue;
    statistics_.tets_nearby += state.level != nullptr;
    ++(state.method == Method::cone ? statistics_.tets_coned
       : state.refined              ? statistics_.tets_refined
                                    : statistics_.tets_monotone);
    sheets_meshed(state.method) += static_cast<std::size_t>(state.sheets);
  }
}

/// The surface and the field are all that is still read: the rest goes before the last arrays are
/// made.
template <class Scalar>
void Pipeline<Scalar>::release_stages() {
  release(complex_, crossings_, edge_vertex_, zero_vertex_, arcs_, face_vertex_, tets_,
          boundary_position_, boundary_medium_, boundary_dominant_);
}

namespace {

bool is_zero(const Vector3<double>& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Where triangles have no area either (a sheet smaller than coordinates tell), vertices without a
/// normal take that of a vertex next to them, in as many rounds as it takes.
void take_normals_of_neighbours(SurfaceMesh& surface) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& triangle : surface.triangles)
      for (const auto v : triangle)
        for (const auto w : triangle) {
          if (!is_zero(surface.normal[as_size(v)]) || is_zero(surface.normal[as_size(w)])) continue;
          surface.normal[as_size(v)] = surface.normal[as_size(w)];
          has_changed = true;
        }
  }
}

/// Where gradients cancel, or rounding hides them (the mode is constant but for that), the normal
/// is the mean of those of the triangles around, by their areas.
void normals_of_triangles(SurfaceMesh& surface) {
  std::vector<char> unknown(surface.normal.size());
  std::transform(surface.normal.begin(), surface.normal.end(), unknown.begin(), is_zero);
  if (std::find(unknown.begin(), unknown.end(), 1) == unknown.end()) return;
  for (const auto& triangle : surface.triangles)
    for (const auto v : triangle) {
      if (!unknown[as_size(v)]) continue;
      const auto& [a, b, c] = triangle;
      const auto& p = surface.points;
      surface.normal[as_size(v)] +=
          cross(p[as_size(b)] - p[as_size(a)], p[as_size(c)] - p[as_size(a)]);
    }
  for (std::size_t v = 0; v < unknown.size(); ++v)
    if (unknown[v]) surface.normal[v] = unit_or_zero(surface.normal[v]);
  take_normals_of_neighbours(surface);
}

}  // namespace

/// What is known at each vertex of the surface.
template <class Scalar>
void Pipeline<Scalar>::describe_vertices(SurfaceMesh& surface,
                                         const std::vector<char>& is_apex) const {
  const auto level = make_level<double>(level_.value);
  const std::size_t count = surface.points.size();
  surface.normal.assign(count, {0, 0, 0});
  surface.mode.assign(count, level_.value.approx());
  surface.residual.assign(count, 0);
  std::vector<Index> first_tet(count, -1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const Index v : surface.triangles[i])
      if (first_tet[as_size(v)] < 0) first_tet[as_size(v)] = surface.tet[i];

  // Normals: the field is only continuous across faces, so a shared vertex gets the mean of the
  // unit gradients in the tetrahedra whose triangles meet there, each weighted by its triangles.
  const auto narrow_tensors = [&](std::size_t tet) {
    std::array<Deviator<Scalar>, 4> tensors;
    for (std::size_t i = 0; i < 4; ++i) tensors[i] = field_.tensors[as_size(mesh_.tets[tet][i])];
    return rounded(tensors);
  };
  const auto geometry = [&](std::size_t tet) {
    const auto& v = mesh_.tets[tet];
    // A vertex isotropic must not decide on the scale.
    std::size_t other = 0;
    while (field_.is_zero[as_size(v[other])]) ++other;
    std::array<int, 4> exponents;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      exponents[i] = field_.exponents[as_size(v[field_.is_zero[as_size(v[i])] ? other : i])];
      points[i] = mesh_.points[as_size(v[i])];
    }
    return TetGeometry(points, exponents);
  };
  // Sums are made in the order of the triangles, a block at a time.
  constexpr std::size_t kBlock = 1 << 14;
  const std::size_t triangles = surface.triangles.size();
  std::vector<std::array<Vector3<double>, 3>> gradients(std::min(kBlock, triangles));
  for (std::size_t first = 0; first < triangles; first += kBlock) {
    const std::size_t size = std::min(kBlock, triangles - first);
    parallel_stage(options_, "stitch", size, 1024, [&](std::size_t i) {
      const auto& corners = surface.triangles[first + i];
      const auto tet = as_size(surface.tet[first + i]);
      const auto tensors = narrow_tensors(tet);
      const auto space = geometry(tet);
      Vector3<double> sum{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = as_size(corners[k]);
        gradients[i][k] = {0, 0, 0};
        if (is_apex[v]) continue;
        const auto at = level_slope(space.balanced_tensor(surface.points[v], tensors), level);
        gradients[i][k] = unit_or_zero(space.gradient(at.slope, tensors));
        sum += gradients[i][k];
      }
      // The gradient's direction is the same along a ray.
      for (std::size_t k = 0; k < 3; ++k)
        if (is_apex[as_size(corners[k])]) gradients[i][k] = unit_or_zero(sum);
    });
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        surface.normal[as_size(surface.triangles[first + i][k])] += gradients[i][k];
  }

  parallel_stage(options_, "stitch", count, 1024, [&](std::size_t id) {
    surface.normal[id] = unit_or_zero(surface.normal[id]);
    if (is_apex[id]) return;
    const auto tet = as_size(first_tet[id]);
    const auto t = geometry(tet).balanced_tensor(surface.points[id], narrow_tensors(tet));
    surface.residual[id] = mode_difference(t, level);
    surface.dominant_eigenvector[id] = dominant_eigenvector(t, level);
  });
  normals_of_triangles(surface);
}

#define TENSORTOPO_INSTANTIATE(Scalar) template Extraction Pipeline<Scalar>::assemble();
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
