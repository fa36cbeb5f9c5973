// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/mesh_around.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "extract/run/assert.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Adds tetrahedra whose meshes depend on each other to those that are done again.
template <class Scalar>
void add_dependent(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                   const std::vector<int>& round_of_face, std::vector<char>& again) {
  const auto& density = input.options.density;
  const auto density_of = [&](Index t) { return density[as_size(cells.tets[as_size(t)])]; };
  std::vector<Index> open;
  for (std::size_t t = 0; t < again.size(); ++t)
    if (again[t]) open.push_back(static_cast<Index>(t));
  while (!open.empty()) {
    const Index t = open.back();
    open.pop_back();
    for (const Index f : cells.tet_faces[as_size(t)]) {
      const auto& both = cells.face_tets[as_size(f)];
      const Index other = both[0] == t ? both[1] : both[0];
      if (other < 0 || again[as_size(other)]) continue;
      if (round_of_face[as_size(f)] == 0 && (density.empty() || density_of(t) == density_of(other)))
        continue;
      again[as_size(other)] = 1;
      open.push_back(other);
    }
  }
}

/// Some tetrahedra of a complex, as one of their own. Tables lead from the complex to it; -1: not
/// among them.
struct Part {
  TetComplex cells;
  std::vector<Index> edges, faces, tets;

  Part(const TetMesh& mesh, const TetComplex& all, const std::vector<char>& chosen)
      : edges(all.edges.size(), -1), faces(all.faces.size(), -1), tets(all.tets.size(), -1) {
    std::vector<Index> list;
    for (std::size_t t = 0; t < chosen.size(); ++t) {
      if (!chosen[t]) continue;
      tets[t] = static_cast<Index>(list.size());
      list.push_back(all.tets[t]);
    }
    cells = tet_complex(mesh, list);
    for (std::size_t t = 0; t < tets.size(); ++t) {
      if (tets[t] < 0) continue;
      const auto own = as_size(tets[t]);
      for (std::size_t e = 0; e < 6; ++e)
        edges[as_size(all.tet_edges[t][e])] = cells.tet_edges[own][e];
      for (std::size_t f = 0; f < 4; ++f)
        faces[as_size(all.tet_faces[t][f])] = cells.tet_faces[own][f];
    }
  }
};

/// Adds those tetrahedra whose faces got samples from the ones that were done again.
/// @return whether there are any
bool add_reached(const TetComplex& cells, const Part& part, const std::vector<int>& round_of_face,
                 std::vector<char>& again) {
  bool any = false;
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (part.faces[f] < 0 || round_of_face[as_size(part.faces[f])] == 0) continue;
    for (const Index t : cells.face_tets[f]) {
      if (t < 0 || again[as_size(t)]) continue;
      again[as_size(t)] = 1;
      any = true;
    }
  }
  return any;
}

/// The rows of a part in the place of those of the whole, and the marks beside them.
template <class Value>
void take_rows(std::span<const Index> from_part, Rows<Value>& rows, std::vector<char>& moved,
               Rows<Value>& of_part, const std::vector<char>& moved_of_part) {
  rows = Rows<Value>(std::move(rows), std::move(of_part), from_part);
  for (std::size_t i = 0; i < from_part.size(); ++i)
    if (from_part[i] >= 0) moved[i] = moved_of_part[as_size(from_part[i])];
}

/// Where crossings and samples begin in a numbering.
struct Starts {
  std::vector<std::size_t> of_edge;
  std::vector<Index> of_face, of_zero;
  std::size_t count;

  template <class Scalar>
  explicit Starts(const CellMeshes<Scalar>& meshes)
      : of_face(meshes.vertices.of_face),
        of_zero(meshes.vertices.of_zero),
        count(meshes.vertices.position.size()) {
    const auto& rows = meshes.boundary.crossings.rows;
    for (std::size_t e = 0; e < rows.size(); ++e) of_edge.push_back(rows.first(e));
  }
};

/// The vertices of one numbering in another.
/// @param edge, face  the edge or face of the old numbering that is one of the new; negative if it
///                    has none
template <class Scalar, class EdgeOf, class FaceOf>
std::vector<Index> new_numbers(const Starts& old, const CellMeshes<Scalar>& meshes,
                               const EdgeOf& edge, const FaceOf& face) {
  std::vector<Index> result(old.count, -1);
  const auto& rows = meshes.boundary.crossings.rows;
  for (std::size_t e = 0; e < rows.size(); ++e)
    if (const Index from = edge(e); from >= 0)
      for (std::size_t k = 0; k < rows[e].size(); ++k)
        result[old.of_edge[as_size(from)] + k] = static_cast<Index>(rows.first(e) + k);
  for (std::size_t v = 0; v < old.of_zero.size(); ++v)
    if (old.of_zero[v] >= 0) result[as_size(old.of_zero[v])] = meshes.vertices.of_zero[v];
  const auto& arcs = meshes.boundary.arcs;
  for (std::size_t f = 0; f < arcs.size(); ++f)
    if (const Index from = face(f); from >= 0) {
      auto id = as_size(old.of_face[as_size(from)]);
      Index next = meshes.vertices.of_face[f];
      for (const auto& arc : arcs[f])
        for (std::size_t k = 0; k < arc.samples.size(); ++k) result[id++] = next++;
    }
  return result;
}

/// Adds what was said in a part, as the next pass.
void add_messages(const Part& part, std::span<const MeshingMessage> of_part,
                  std::vector<MeshingMessage>& messages) {
  std::int32_t pass = 0;
  for (const MeshingMessage& message : messages) pass = std::max(pass, message.pass);
  std::vector<Index> whole(part.cells.tets.size(), -1);
  for (std::size_t t = 0; t < part.tets.size(); ++t)
    if (part.tets[t] >= 0) whole[as_size(part.tets[t])] = static_cast<Index>(t);
  for (MeshingMessage message : of_part) {
    message.from = whole[as_size(message.from)], message.to = whole[as_size(message.to)];
    message.pass = pass + 1;
    messages.push_back(message);
  }
}

/// Puts a part in the place of what the whole had there.
template <class Scalar>
void merge(const SurfaceInput<Scalar>& input, const VertexSides& sides, const TetComplex& cells,
           const Part& part, MeshedLevel<Scalar>& level, MeshedLevel<Scalar> again) {
  auto& meshes = level.meshes;
  add_messages(part, again.meshes.messages, meshes.messages);
  const Starts old(meshes), old_of_part(again.meshes);
  auto rounds = std::move(meshes.vertices.round_of_face);
  for (std::size_t f = 0; f < rounds.size(); ++f)
    if (part.faces[f] >= 0) rounds[f] = again.meshes.vertices.round_of_face[as_size(part.faces[f])];
  auto& boundary = meshes.boundary;
  auto& of_part = again.meshes.boundary;
  take_rows(part.edges, boundary.crossings.rows, boundary.crossings.moved, of_part.crossings.rows,
            of_part.crossings.moved);
  take_rows(part.faces, boundary.arcs, boundary.moved, of_part.arcs, of_part.moved);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    if (part.tets[t] < 0) continue;
    level.proofs[t] = std::move(again.proofs[as_size(part.tets[t])]);
    meshes.cells[t] = std::move(again.meshes.cells[as_size(part.tets[t])]);
  }
  meshes.vertices =
      number_boundary<Scalar>(input, sides, cells, boundary, level.proofs, std::move(rounds));
  // Edges and faces of the part may be those of other tetrahedra, too: they are the same there.
  std::vector<char> edge_of_others(part.edges.size(), 0), face_of_others(part.faces.size(), 0);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    if (part.tets[t] >= 0) continue;
    for (const Index e : cells.tet_edges[t]) edge_of_others[as_size(e)] = 1;
    for (const Index f : cells.tet_faces[t]) face_of_others[as_size(f)] = 1;
  }
  const auto kept = [](const std::vector<char>& is_kept) {
    return [&](std::size_t i) { return is_kept[i] ? static_cast<Index>(i) : Index{-1}; };
  };
  const auto numbers = new_numbers(old, meshes, kept(edge_of_others), kept(face_of_others));
  const auto numbers_of_part = new_numbers(
      old_of_part, meshes, [&](std::size_t e) { return part.edges[e]; },
      [&](std::size_t f) { return part.faces[f]; });
  parallel_stage(input.options, "tetrahedra", part.tets.size(), 1024, [&](std::size_t t) {
    const auto& ids = part.tets[t] < 0 ? numbers : numbers_of_part;
    for (auto& triangle : meshes.cells[t].patch.triangles)
      for (Index& corner : triangle) {
        if (corner < 0) continue;
        corner = ids[as_size(corner)];
        TENSORTOPO_ASSERT(corner >= 0, "vertices of a patch stay where their edge or face is kept");
      }
  });
}

}  // namespace

template <class Scalar>
std::vector<char> keep_off_pinched(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                   const CellMeshes<Scalar>& meshes, VertexSides& sides) {
  std::vector<char> moved;
  for (std::size_t t = 0; t < meshes.cells.size(); ++t) {
    if (meshes.cells[t].unresolved != UnresolvedReason::inconsistent_samples) continue;
    for (const auto v : input.vertices_of(cells, t)) {
      auto& on_level = sides.on_level[as_size(v)];
      if (on_level != OnLevel::meshed_through) continue;
      on_level = OnLevel::kept_off;
      moved.resize(sides.on_level.size(), 0);
      moved[as_size(v)] = 1;
    }
  }
  return moved;
}

template <class Scalar>
std::vector<char> keep_as_meshed(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                 const CellMeshes<Scalar>& meshes, VertexSides& sides) {
  std::vector<char> at_mended(sides.as_meshed.size(), 0);
  for (std::size_t t = 0; t < meshes.cells.size(); ++t)
    if (meshes.cells[t].was_mended)
      for (const auto v : input.vertices_of(cells, t)) at_mended[as_size(v)] = 1;
  std::vector<char> changed;
  for (std::size_t t = 0; t < meshes.cells.size(); ++t) {
    if (meshes.cells[t].unresolved != UnresolvedReason::inconsistent_samples) continue;
    const auto& vertices = input.vertices_of(cells, t);
    const bool is_open = std::any_of(vertices.begin(), vertices.end(), [&](Index v) {
      return at_mended[as_size(v)] && !sides.as_meshed[as_size(v)];
    });
    if (!is_open) continue;
    changed.resize(at_mended.size(), 0);
    for (const auto v : vertices) changed[as_size(v)] = 1;
  }
  for (std::size_t v = 0; v < changed.size(); ++v)
    if (changed[v]) sides.as_meshed[v] = 1;
  return changed;
}

template <class Scalar>
std::size_t mesh_around(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                        const TetComplex& cells, const std::vector<char>& changed,
                        MeshedLevel<Scalar>& level, StageSeconds& seconds) {
  std::vector<char> again(cells.tets.size(), 0);
  for (std::size_t t = 0; t < again.size(); ++t)
    for (const auto v : input.vertices_of(cells, t)) again[t] |= changed[as_size(v)];
  // Ends: each time there are more of them.
  for (;;) {
    add_dependent(input, cells, level.meshes.vertices.round_of_face, again);
    const Part part(input.mesh, cells, again);
    auto done = mesh_level(input, sides, part.cells, seconds);
    if (add_reached(cells, part, done.meshes.vertices.round_of_face, again)) continue;
    merge(input, sides, cells, part, level, std::move(done));
    return part.cells.tets.size();
  }
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                        \
  template std::vector<char> keep_off_pinched(const SurfaceInput<Scalar>&, const TetComplex&, \
                                              const CellMeshes<Scalar>&, VertexSides&);       \
  template std::vector<char> keep_as_meshed(const SurfaceInput<Scalar>&, const TetComplex&,   \
                                            const CellMeshes<Scalar>&, VertexSides&);         \
  template std::size_t mesh_around(const SurfaceInput<Scalar>&, const VertexSides&,           \
                                   const TetComplex&, const std::vector<char>&,               \
                                   MeshedLevel<Scalar>&, StageSeconds&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
