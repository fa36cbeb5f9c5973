// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/assemble.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "extract/level/position.hpp"
#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/cone_sheets.hpp"
#include "extract/surface/cone_tips.hpp"
#include "extract/surface/crossing_fans.hpp"
#include "extract/surface/describe_vertices.hpp"
#include "extract/surface/proved_topology.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {

namespace {

/// How the tetrahedra with triangles were proved and meshed.
template <class Scalar>
void count_sheets(std::span<const CellProof<Scalar>> proofs, const CellMeshes<Scalar>& meshes,
                  ExtractStatistics& statistics) {
  const auto sheets_meshed = [&](Mesher mesher) -> std::size_t& {
    switch (mesher) {
      case Mesher::tubes:
        return statistics.sheets_tubes;
      case Mesher::bisected:
        return statistics.sheets_bisected;
      case Mesher::small_disc:
        return statistics.sheets_small;
      case Mesher::graph:
        return statistics.sheets_graph;
      case Mesher::manifold:
        return statistics.sheets_manifold;
      case Mesher::dominant:
        return statistics.sheets_dominant;
      case Mesher::loops:
        return statistics.sheets_loops;
      case Mesher::cone:
        return statistics.sheets_cones;
      case Mesher::subdivision:
      case Mesher::fan:
        break;
    }
    return statistics.sheets_subdivision;
  };
  for (std::size_t t = 0; t < proofs.size(); ++t) {
    const auto& mesh = meshes.cells[t];
    if (mesh.patch.triangles.empty()) continue;
    ++statistics.tets_crossed;
    statistics.tets_nearby += proofs[t].level != nullptr;
    ++(mesh.mesher == Mesher::cone ? statistics.tets_coned
       : mesh.refined              ? statistics.tets_refined
                                   : statistics.tets_monotone);
    sheets_meshed(mesh.mesher) += static_cast<std::size_t>(mesh.sheets);
  }
}

/// Whether the Euler characteristic of the triangles is that of sheets without their boundaries, of
/// arcs without their ends, and of crossings, together: closed curves have none. Around isotropic
/// vertices nothing is asked.
/// @param crossings  vertices on edges that some triangle has
template <class Scalar>
[[maybe_unused]] bool do_characteristics_add_up(const TetComplex& cells,
                                                std::span<const CellProof<Scalar>> proofs,
                                                const CellMeshes<Scalar>& meshes,
                                                std::size_t crossings, const SurfaceMesh& surface) {
  const auto is_meshed = [&](TetMesh::Index t) {
    return t >= 0 && !meshes.cells[as_size(t)].patch.triangles.empty();
  };
  auto sum = static_cast<long>(crossings);
  for (std::size_t t = 0; t < proofs.size(); ++t) {
    if (!is_meshed(static_cast<TetMesh::Index>(t))) continue;
    if (proofs[t].is_cone || !proofs[t].topology) return true;
    for (const auto& sheet : proofs[t].topology->sheets) sum += sheet.euler_characteristic;
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (std::none_of(cells.face_tets[f].begin(), cells.face_tets[f].end(), is_meshed)) continue;
    for (const auto& arc : meshes.boundary.arcs[f]) sum -= arc.closed ? 0 : 1;
  }
  return sum == surface_invariants(surface).euler_characteristic;
}

}  // namespace

template <class Scalar>
Extraction assemble(const SurfaceInput<Scalar>& input, const VertexSides& sides, ActiveCells active,
                    std::vector<CellProof<Scalar>> proofs, CellMeshes<Scalar> meshes) {
  using Index = TetMesh::Index;
  const auto& cells = active.complex;
  const auto& numbers = meshes.vertices;
  const auto& rows = meshes.boundary.crossings.rows;
  const std::size_t tets = meshes.cells.size();
  Extraction result;
  result.statistics.tets_screened_out = active.screened_out;
  result.statistics.tets_undefined = active.undefined;
  result.statistics.zero_deviator_vertices = active.zero_vertices;
  SurfaceMesh& surface = result.surface;
  for (std::size_t t = 0; t < tets; ++t)
    if (meshes.cells[t].has_defects && !meshes.cells[t].unresolved)
      result.not_embedded.push_back(cells.tets[t]);
    else if (auto& mesh = meshes.cells[t]; mesh.unresolved) {
      mesh.patch = {};
      result.unresolved.push_back({cells.tets[t], *mesh.unresolved});
    }

  // Output ids: used edge vertices, isotropic vertices, used face vertices, inner vertices, copies
  // of edge vertices; each by the edge, vertex, face or tetrahedron.
  const auto boundary_count = numbers.position.size();
  std::vector<Index> new_id(boundary_count, -1);
  parallel_stage(input.options, "stitch", tets, 1024, [&](std::size_t t) {
    for (const auto& triangle : meshes.cells[t].patch.triangles)
      for (const auto corner : triangle)
        if (corner >= 0)
          std::atomic_ref(new_id[as_size(corner)]).store(0, std::memory_order_relaxed);
  });
  Index next = 0;
  const auto number = [&](std::size_t v) {
    if (new_id[v] == 0) new_id[v] = next++;
  };
  for (std::size_t v = 0; v < rows.count(); ++v) number(v);
  for (const Index v : numbers.of_zero)
    if (v >= 0) number(as_size(v));
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    auto v = as_size(numbers.of_face[f]);
    for (const auto& arc : meshes.boundary.arcs[f])
      for (std::size_t k = 0; k < arc.samples.size(); ++k) number(v++);
  }
  const auto boundary_used = next;
  const CrossingCopies copies = crossing_copies(input.options, cells, meshes);
  if (input.options.keep_topology)
    result.topology = proved_topology<Scalar>(input, cells, proofs, meshes, new_id);
  std::vector<Index> inner_first(tets + 1, boundary_used), first_triangle(tets + 1, 0);
  for (std::size_t t = 0; t < tets; ++t) {
    const auto& patch = meshes.cells[t].patch;
    inner_first[t + 1] = inner_first[t] + static_cast<Index>(patch.inner.size());
    first_triangle[t + 1] = first_triangle[t] + static_cast<Index>(patch.triangles.size());
  }
  const auto count = as_size(inner_first.back()) + copies.original.size();

  surface.points.resize(count);
  surface.carrier.resize(count);
  surface.carrier_id.resize(count);
  surface.carrier_vertices.resize(count);
  surface.medium_eigenvector.resize(count);
  surface.dominant_eigenvector.resize(count);
  surface.triangles.resize(as_size(first_triangle.back()));
  surface.tet.resize(surface.triangles.size());

  const auto carry = [&](Index v, std::size_t simplex, std::span<const Index> vertices,
                         Carrier carrier) {
    const auto id = new_id[as_size(v)];
    if (id < 0) return;
    surface.carrier[as_size(id)] = carrier;
    surface.carrier_id[as_size(id)] = static_cast<Index>(simplex);
    surface.carrier_vertices[as_size(id)] = {-1, -1, -1, -1};
    std::copy(vertices.begin(), vertices.end(), surface.carrier_vertices[as_size(id)].begin());
    surface.points[as_size(id)] = numbers.position[as_size(v)];
    surface.medium_eigenvector[as_size(id)] = numbers.medium[as_size(v)];
    surface.dominant_eigenvector[as_size(id)] = numbers.dominant[as_size(v)];
  };
  parallel_stage(input.options, "stitch", cells.edges.size(), 1024, [&](std::size_t e) {
    for (std::size_t k = 0; k < rows[e].size(); ++k)
      carry(static_cast<Index>(rows.first(e) + k), e, cells.edges[e], Carrier::edge);
  });
  parallel_stage(input.options, "stitch", cells.faces.size(), 1024, [&](std::size_t f) {
    auto v = numbers.of_face[f];
    for (const auto& arc : meshes.boundary.arcs[f])
      for (std::size_t k = 0; k < arc.samples.size(); ++k)
        carry(v++, f, cells.faces[f], Carrier::face);
  });
  for (std::size_t k = 0; k < copies.original.size(); ++k) {
    const auto original = new_id[as_size(copies.original[k])];
    const auto id = inner_first.back() + static_cast<Index>(k);
    const auto from = as_size(original), to = as_size(id);
    surface.carrier[to] = surface.carrier[from];
    surface.carrier_id[to] = surface.carrier_id[from];
    surface.carrier_vertices[to] = surface.carrier_vertices[from];
    surface.points[to] = surface.points[from];
    surface.medium_eigenvector[to] = surface.medium_eigenvector[from];
    surface.dominant_eigenvector[to] = surface.dominant_eigenvector[from];
    if (input.options.keep_topology) result.topology.copies.push_back({original, id});
  }
  std::vector<char> is_apex(count, 0);
  for (std::size_t v = 0; v < numbers.of_zero.size(); ++v) {
    if (numbers.of_zero[v] < 0 || new_id[as_size(numbers.of_zero[v])] < 0) continue;
    carry(numbers.of_zero[v], v, std::array{static_cast<Index>(v)}, Carrier::vertex);
    is_apex[as_size(new_id[as_size(numbers.of_zero[v])])] = 1;
  }

  parallel_stage(input.options, "stitch", tets, 256, [&](std::size_t t) {
    const auto& inner = meshes.cells[t].patch.inner;
    if (inner.empty()) return;
    const auto& v = input.mesh.tets[as_size(cells.tets[t])];
    std::array<int, 4> exponents;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      exponents[i] = input.field.exponents[as_size(v[i])];
      points[i] = input.mesh.points[as_size(v[i])];
    }
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const auto id = as_size(inner_first[t]) + k;
      surface.carrier[id] = Carrier::tet;
      surface.carrier_id[id] = cells.tets[t];
      surface.carrier_vertices[id] = v;
      std::sort(surface.carrier_vertices[id].begin(), surface.carrier_vertices[id].end());
      surface.points[id] = position_at(inner[k].weights, exponents, points);
      surface.medium_eigenvector[id] =
          vector_cast<double>(medium_eigenvector(inner[k].tensor, input.level));
      surface.dominant_eigenvector[id] =
          vector_cast<double>(dominant_eigenvector(inner[k].tensor, input.level));
    }
  });

  parallel_stage(input.options, "stitch", tets, 1024, [&](std::size_t t) {
    auto next_triangle = as_size(first_triangle[t]);
    for (const auto& triangle : meshes.cells[t].patch.triangles) {
      auto& corners = surface.triangles[next_triangle];
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] =
            triangle[i] >= 0 ? new_id[as_size(triangle[i])] : inner_first[t] + (-1 - triangle[i]);
        if (const auto copy = copies.of.find({t, triangle[i]}); copy != copies.of.end())
          corners[i] = inner_first.back() + static_cast<Index>(copy->second);
      }
      surface.tet[next_triangle++] = cells.tets[t];
    }
  });

  TENSORTOPO_ASSERT(
      do_characteristics_add_up<Scalar>(
          cells, proofs, meshes,
          static_cast<std::size_t>(std::count_if(
              new_id.begin(), new_id.begin() + static_cast<std::ptrdiff_t>(rows.count()),
              [](Index id) { return id >= 0; })) +
              copies.original.size(),
          surface),
      "the surface has the Euler characteristic of its sheets, arcs and crossings");
  result.statistics.cone_points = add_cone_tips(input, sides, cells, meshes, surface, is_apex);
  if (input.options.keep_topology)
    result.topology.cones = cone_sheets(surface, is_apex, result.topology.copies);
  count_sheets<Scalar>(proofs, meshes, result.statistics);
  // The surface and the field are all that is still read: the rest goes before the last arrays are
  // made.
  parallel_stage(input.options, "stitch", tets, 1024,
                 [&](std::size_t t) { release(proofs[t], meshes.cells[t]); });
  meshes.boundary.arcs.clear(input.options, "stitch");
  release(active, proofs, meshes);
  describe_vertices(input, is_apex, surface);
  surface.component = surface_components(surface);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                       \
  template Extraction assemble(const SurfaceInput<Scalar>&, const VertexSides&, ActiveCells, \
                               std::vector<CellProof<Scalar>>, CellMeshes<Scalar>);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
