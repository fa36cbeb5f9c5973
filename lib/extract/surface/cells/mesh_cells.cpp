// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/mesh_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/cells/cell_mesher.hpp"
#include "extract/surface/cells/part_seam.hpp"
#include "extract/surface/cells/sample_requests.hpp"

namespace tensortopo {

namespace {

template <class Scalar>
void begin(const SurfaceInput<Scalar>& input, const VertexSides& sides, const TetComplex& cells,
           std::vector<CellProof<Scalar>>& proofs, MeshingStates<Scalar>& states,
           CellMeshes<Scalar>& meshes) {
  const auto state_of = [&](std::size_t t) -> MeshingState<Scalar>& {
    if (!states[t]) states[t] = std::make_unique<MeshingState<Scalar>>();
    return *states[t];
  };
  parallel_stage(input.options, "tetrahedra", proofs.size(), 1024, [&](std::size_t t) {
    auto& mesh = meshes.cells[t];
    mesh.unresolved = proofs[t].unresolved;
    if (!proofs[t].topology) return;
    for (const auto v : input.vertices_of(cells, t))
      if (sides.as_meshed[as_size(v)]) state_of(t).must_be_embedded = false;
    // Nearly all tetrahedra begin with small polygons, as a `CellMesh` does.
    if (!proofs[t].is_cone && proofs[t].topology->tubes.empty()) return;
    const CellSurroundings<Scalar> around{cells, meshes.boundary, meshes.vertices, t};
    CellMesher<Scalar>(input, sides, around, proofs[t], state_of(t), mesh).begin();
  });
}

/// Notes what tetrahedra that could not be meshed ask for on faces between parts.
template <class Scalar>
void note_requests(const PartSeam& seam, std::span<const std::size_t> failed,
                   const MeshingStates<Scalar>& states, int round, CellMeshes<Scalar>& meshes) {
  for (const auto t : failed) {
    // As for those who add the samples: nothing is asked for by what is left out, and the mesh of a
    // subdivision needs these very points.
    if (meshes.cells[t].unresolved) continue;
    const double is_needed = meshes.cells[t].mesher == Mesher::subdivision ? 1 : 0;
    for (std::size_t face = 0; face < 4; ++face) {
      const auto other = seam.across(t, face);
      if (other < 0) continue;
      bool any = false;
      std::uint64_t digest = 0;
      for (const auto& request : states[t]->requests) {
        if (as_size(request.face) != face || request.arc < 0) continue;
        any = true;
        digest += digest_of(std::array{is_needed, static_cast<double>(request.arc),
                                       static_cast<double>(request.place)});
      }
      if (any)
        meshes.messages.push_back({static_cast<TetMesh::Index>(t), other, 0,
                                   MeshingMessage::kFirstRequest - 1 + round, digest});
    }
  }
}

/// Notes which tetrahedra were left out beside another part, and which around them were mended.
template <class Scalar>
void note_left_out(const PartSeam& seam, const SurfaceInput<Scalar>& input, const TetComplex& cells,
                   const MeshingStates<Scalar>& states, CellMeshes<Scalar>& meshes) {
  std::map<TetMesh::Index, std::vector<std::size_t>> left_out;  // at a vertex
  for (std::size_t t = 0; t < meshes.cells.size(); ++t)
    if (meshes.cells[t].unresolved == UnresolvedReason::inconsistent_samples)
      for (const auto v : input.vertices_of(cells, t)) left_out[v].push_back(t);
  if (left_out.empty()) return;
  const auto is_mended = [&](std::size_t t) { return states[t] && states[t]->tried > 0 ? 1u : 0u; };
  std::vector<MeshingMessage> found;
  for (std::size_t u = 0; u < meshes.cells.size(); ++u)
    for (const auto v : input.vertices_of(cells, u)) {
      const auto at = left_out.find(v);
      if (at == left_out.end()) continue;
      for (const std::size_t t : at->second) {
        if (!seam.parts(t, u)) continue;
        const auto from = static_cast<TetMesh::Index>(t), to = static_cast<TetMesh::Index>(u);
        found.push_back({from, to, 0, MeshingMessage::kLeftOut, 2 + is_mended(t)});
        found.push_back({to, from, 0, MeshingMessage::kLeftOut, is_mended(u)});
      }
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  meshes.messages.insert(meshes.messages.end(), found.begin(), found.end());
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
  CellMeshes<Scalar> meshes{
      std::vector<CellMesh<Scalar>>(proofs.size()), std::move(boundary), {}, {}};
  meshes.vertices = number_boundary<Scalar>(input, sides, cells, meshes.boundary, proofs,
                                            std::vector<int>(cells.faces.size(), 0));
  MeshingStates<Scalar> states(proofs.size());
  begin(input, sides, cells, proofs, states, meshes);

  const auto mesher_of = [&](std::size_t t, MeshingState<Scalar>& state) {
    return CellMesher<Scalar>(input, sides, {cells, meshes.boundary, meshes.vertices, t}, proofs[t],
                              state, meshes.cells[t]);
  };
  const auto is_open = [&](std::size_t t) {
    return proofs[t].topology && !meshes.cells[t].unresolved;
  };
  const PartSeam seam(input.options, cells);
  std::vector<std::size_t> meshing;
  for (std::size_t t = 0; t < proofs.size(); ++t)
    if (is_open(t)) meshing.push_back(t);
  for (int round = 1; !meshing.empty(); ++round) {
    std::vector<char> done(meshing.size(), 0);
    // After the first round only tetrahedra remain that take long, and those are neighbours.
    const std::size_t grain = round == 1 ? 16 : 1;
    parallel_stage(input.options, "tetrahedra", meshing.size(), grain, [&](std::size_t i) {
      const auto t = meshing[i];
      MeshingState<Scalar> first;
      done[i] = mesher_of(t, states[t] ? *states[t] : first).try_mesher();
      if (!states[t] && (!done[i] || first.tried > 0))
        states[t] = std::make_unique<MeshingState<Scalar>>(std::move(first));
      TENSORTOPO_ASSERT(!done[i] || are_corners_known(meshes.cells[t].patch, meshes.vertices),
                        "corners of a patch are vertices");
    });
    // Ends: a tetrahedron fails at most once with each mesher and number of samples.
    std::vector<std::size_t> failed;
    for (std::size_t i = 0; i < meshing.size(); ++i)
      if (!done[i]) failed.push_back(meshing[i]);
    parallel_stage(input.options, "tetrahedra", failed.size(), grain,
                   [&](std::size_t i) { mesher_of(failed[i], *states[failed[i]]).choose_next(); });
    if (seam.exists()) note_requests<Scalar>(seam, failed, states, round, meshes);
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
  if (seam.exists()) note_left_out<Scalar>(seam, input, cells, states, meshes);
  parallel_stage(input.options, "tetrahedra", proofs.size(), 1024, [&](std::size_t t) {
    const auto state = std::move(states[t]);
    if (!proofs[t].topology) return;
    meshes.cells[t].sheets = static_cast<int>(proofs[t].topology->sheets.size());
    meshes.cells[t].was_mended = state && state->tried > 0;
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
