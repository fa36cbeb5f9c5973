// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/mesh_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/cells/cell_mesher.hpp"
#include "extract/surface/cells/sample_requests.hpp"

namespace tensortopo {

namespace {

template <class Scalar>
void begin(const SurfaceInput<Scalar>& input, const VertexSides& sides, const TetComplex& cells,
           std::vector<CellProof<Scalar>>& proofs, std::vector<MeshingState<Scalar>>& states,
           CellMeshes<Scalar>& meshes) {
  parallel_stage(input.options, "tetrahedra", proofs.size(), 1024, [&](std::size_t t) {
    auto& mesh = meshes.cells[t];
    mesh.unresolved = proofs[t].unresolved;
    if (!proofs[t].topology) return;
    for (const auto v : input.vertices_of(cells, t))
      if (sides.as_meshed[as_size(v)]) states[t].must_be_embedded = false;
    // Nearly all tetrahedra begin with small polygons, as a `CellMesh` does.
    if (!proofs[t].is_cone && proofs[t].topology->tubes.empty()) return;
    const CellSurroundings<Scalar> around{cells, meshes.boundary, meshes.vertices, t};
    CellMesher<Scalar>(input, sides, around, proofs[t], states[t], mesh).begin();
  });
}

/// Corners on the boundary have numbers, those inside are among the patch's own.
template <class Scalar>
[[maybe_unused]] bool are_corners_known(const Patch<Scalar>& patch,
                                        const BoundaryVertices& vertices) {
  return std::all_of(patch.triangles.begin(), patch.triangles.end(), [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), [&](TetMesh::Index v) {
      return v >= 0 ? as_size(v) < vertices.position.size() : as_size(-1 - v) < patch.inner.size();
    });
  });
}

}  // namespace

template <class Scalar>
CellMeshes<Scalar> mesh_cells(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                              const TetComplex& cells, LevelBoundary<Scalar> boundary,
                              std::vector<CellProof<Scalar>>& proofs) {
  CellMeshes<Scalar> meshes{std::vector<CellMesh<Scalar>>(proofs.size()), std::move(boundary), {}};
  meshes.vertices = number_boundary<Scalar>(input, sides, cells, meshes.boundary, proofs,
                                            std::vector<int>(cells.faces.size(), 0));
  std::vector<MeshingState<Scalar>> states(proofs.size());
  begin(input, sides, cells, proofs, states, meshes);

  const auto mesher_of = [&](std::size_t t) {
    return CellMesher<Scalar>(input, sides, {cells, meshes.boundary, meshes.vertices, t}, proofs[t],
                              states[t], meshes.cells[t]);
  };
  const auto is_open = [&](std::size_t t) {
    return proofs[t].topology && !meshes.cells[t].unresolved;
  };
  std::vector<std::size_t> meshing;
  for (std::size_t t = 0; t < proofs.size(); ++t)
    if (is_open(t)) meshing.push_back(t);
  for (int round = 1; !meshing.empty(); ++round) {
    std::vector<char> done(meshing.size(), 0);
    parallel_stage(input.options, "tetrahedra", meshing.size(), 16, [&](std::size_t i) {
      done[i] = mesher_of(meshing[i]).try_mesher();
      TENSORTOPO_ASSERT(
          !done[i] || are_corners_known(meshes.cells[meshing[i]].patch, meshes.vertices),
          "corners of a patch are vertices");
    });
    // Ends: a tetrahedron fails at most once with each mesher and number of samples.
    std::vector<std::size_t> failed;
    for (std::size_t i = 0; i < meshing.size(); ++i)
      if (!done[i]) failed.push_back(meshing[i]);
    parallel_stage(input.options, "tetrahedra", failed.size(), 16,
                   [&](std::size_t i) { mesher_of(failed[i]).choose_next(); });
    const auto changed = add_requested_samples<Scalar>(input, sides, cells, failed, states, meshes);
    for (const auto f : changed) meshes.vertices.round_of_face[f] = round;
    number_samples<Scalar>(input, cells, meshes.boundary, changed, meshes.vertices);
    meshing.clear();
    for (const auto t : failed)
      if (!meshes.cells[t].unresolved) meshing.push_back(t);
    for (const auto f : changed)
      for (const auto t : cells.face_tets[f])
        if (t >= 0 && is_open(as_size(t))) meshing.push_back(as_size(t));
    std::sort(meshing.begin(), meshing.end());
    meshing.erase(std::unique(meshing.begin(), meshing.end()), meshing.end());
  }
  parallel_stage(input.options, "tetrahedra", proofs.size(), 1024, [&](std::size_t t) {
    release(states[t].manifold, states[t].requests);
    if (!proofs[t].topology) return;
    meshes.cells[t].sheets = static_cast<int>(proofs[t].topology->sheets.size());
    meshes.cells[t].was_mended = states[t].tried > 0;
    meshes.cells[t].refined = proofs[t].topology->refined;
  });
  return meshes;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                    \
  template CellMeshes<Scalar> mesh_cells(const SurfaceInput<Scalar>&, const VertexSides&, \
                                         const TetComplex&, LevelBoundary<Scalar>,        \
                                         std::vector<CellProof<Scalar>>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
