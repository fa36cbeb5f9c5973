// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "isotropic_tets.hpp"
#include "owned_part.hpp"
#include "piece_messages.hpp"
#include "tensortopo/partition/piece_surface.hpp"
#include "topology/topology_parts.hpp"
#include "vertices_on_level.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Face = std::array<Index, 3>;

/// Of each vertex how many before it have the same carrier.
std::vector<std::int32_t> ordinals_of(const SurfaceMesh& surface) {
  std::vector<std::size_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t v) {
    return std::tie(surface.carrier[v], surface.carrier_vertices[v]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t u, std::size_t v) { return key(u) < key(v); });
  std::vector<std::int32_t> ordinals(order.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (key(order[i]) == key(order[i - 1])) ordinals[order[i]] = ordinals[order[i - 1]] + 1;
  return ordinals;
}

/// A face between an owned tetrahedron and a ghost.
struct SeamFace {
  Face face;
  std::int64_t ghost;  ///< its id
};

/// Ascending.
std::vector<SeamFace> seam_faces(const MeshPiece& piece) {
  std::vector<std::pair<Face, std::size_t>> faces;
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t) {
    auto v = piece.mesh.tets[t];
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < 4; ++i)
      faces.push_back({{v[i == 0 ? 1 : 0], v[i < 2 ? 2 : 1], v[i < 3 ? 3 : 2]}, t});
  }
  std::sort(faces.begin(), faces.end());
  std::vector<SeamFace> seam;
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const auto& [face, t] = faces[i - 1];
    const auto& [next, u] = faces[i];
    if (face != next || (piece.is_owned[t] != 0) == (piece.is_owned[u] != 0)) continue;
    seam.push_back({face, piece.mesh.cell_ids[piece.is_owned[t] != 0 ? u : t]});
  }
  return seam;
}

/// The ghost across the face that holds two vertices of the surface, or -1.
std::int64_t ghost_across(const std::vector<SeamFace>& seam, const std::array<Index, 4>& a,
                          const std::array<Index, 4>& b) {
  std::array<Index, 8> all{};
  auto end = std::copy_if(a.begin(), a.end(), all.begin(), [](Index v) { return v >= 0; });
  end = std::copy_if(b.begin(), b.end(), end, [](Index v) { return v >= 0; });
  std::sort(all.begin(), end);
  end = std::unique(all.begin(), end);
  if (end - all.begin() != 3) return -1;
  const Face face{all[0], all[1], all[2]};
  const auto found =
      std::lower_bound(seam.begin(), seam.end(), face,
                       [](const SeamFace& known, const Face& f) { return known.face < f; });
  return found != seam.end() && found->face == face ? found->ghost : -1;
}

/// Takes out of the surface of a piece's mesh what lies in ghosts.
/// @param result  its `surface`, and `topology` if it has one, count in the piece's mesh
void keep_surface(const MeshPiece& piece, PieceSurface& result) {
  result.owned_ids = owned_ids_of(piece);
  result.isotropic_ids = isotropic_ids_of(piece);
  result.whole_tets = piece.whole_tets;
  result.ordinals = ordinals_of(result.surface);
  keep_owned(piece, result);
  const auto faces = seam_faces(piece);
  const auto& carriers = result.surface.carrier_vertices;
  for (const auto& t : result.surface.triangles) {
    const auto across = [&](std::size_t i) {
      return ghost_across(faces, carriers[as_size(t[i])], carriers[as_size(t[(i + 1) % 3])]);
    };
    result.ghost_across.push_back({across(0), across(1), across(2)});
  }
  gather_cells(piece, result);
}

void require_in_order(const MeshPiece& piece) {
  require_sound(piece);
  if (!std::is_sorted(piece.vertex_ids.begin(), piece.vertex_ids.end()))
    throw std::invalid_argument("piece: its vertices are not in the order of their ids; sort them");
}

}  // namespace

PieceSurface owned_surface(const MeshPiece& piece, SurfaceMesh surface) {
  require_in_order(piece);
  PieceSurface result;
  result.surface = std::move(surface);
  keep_surface(piece, result);
  return result;
}

PieceSurface owned_surface(const MeshPiece& piece, const ModeValue& mode, Extraction made,
                           bool is_proof) {
  require_in_order(piece);
  PieceSurface result;
  result.surface = std::move(made.surface);
  for (const UnresolvedCell& cell : made.unresolved)
    if (piece.is_owned[as_size(cell.tet)])
      result.unresolved.push_back({piece.mesh.cell_ids[as_size(cell.tet)], cell.reason});
  for (const TetMesh::Index tet : made.not_embedded)
    if (piece.is_owned[as_size(tet)])
      result.not_embedded.push_back(piece.mesh.cell_ids[as_size(tet)]);
  std::sort(result.not_embedded.begin(), result.not_embedded.end());
  if (made.statistics.vertices_on_level > 0) result.on_level = vertices_on_level(piece, mode);
  if (is_proof) result.topology = topology_of_owned(std::move(made.topology), piece);
  add_messages(piece, made.messages, result.told, result.heard);
  keep_surface(piece, result);
  return result;
}

PieceSurface extract_piece(const MeshPiece& given, const ModeValue& mode,
                           const ExtractOptions& options) {
  require_sound(given);
  const MeshPiece piece = in_order_of_ids(given);
  ExtractOptions in_parts = options;
  in_parts.part = piece.is_owned;
  return owned_surface(piece, mode, extract_mode_surface<double>(piece.mesh, mode, in_parts),
                       options.keep_topology);
}

}  // namespace tensortopo
