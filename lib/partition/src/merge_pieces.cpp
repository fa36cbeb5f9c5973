// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "crossed_cells.hpp"
#include "differing_pieces.hpp"
#include "piece_messages.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/partition/piece_surface.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// In the order in which an extraction numbers its vertices.
enum class VertexClass { crossing, isotropic, sample, inner, copy, halfway, tip };

/// A vertex of one of the pieces.
struct PieceVertex {
  VertexClass kind{};
  std::array<Index, 4> carrier{};  ///< in canonical numbers, ascending; -1 fills up
  std::int32_t ordinal = 0;
  std::size_t piece = 0;
  Index vertex = 0;
  std::size_t original = 0;  ///< of a copy: which of the whole surface's it is one of

  auto key() const { return std::tie(kind, carrier, ordinal); }
};

class Merger {
 public:
  explicit Merger(std::span<const PieceSurface> pieces)
      : pieces_(pieces),
        cells_(crossed_cells(pieces)),
        canonical_(canonical_mesh(cells_.mesh)),
        vertex_rank_(inverse_permutation(canonical_.vertices)),
        tet_rank_(inverse_permutation(canonical_.tets)) {}

  MergedSurface run() {
    find_vertices();
    find_triangles();
    number_vertices();
    fill();
    check_seams();
    fill_cells();
    return std::move(result_);
  }

 private:
  struct PieceTriangle {
    Index rank;
    std::size_t piece, triangle;
    auto operator<=>(const PieceTriangle&) const = default;
  };

  std::array<Index, 4> carrier_of(std::size_t piece, Index v) const {
    auto carrier = pieces_[piece].surface.carrier_vertices[as_size(v)];
    const auto end = std::find(carrier.begin(), carrier.end(), -1);
    for (auto i = carrier.begin(); i != end; ++i)
      *i = vertex_rank_[as_size(cells_.vertex_of[piece][as_size(*i)])];
    std::sort(carrier.begin(), end);
    return carrier;
  }

  /// All vertices of all pieces, and which are one.
  void find_vertices() {
    std::vector<PieceVertex> all;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (std::size_t v = 0; v < pieces_[p].surface.points.size(); ++v)
        all.push_back({{},
                       carrier_of(p, static_cast<Index>(v)),
                       pieces_[p].ordinals[v],
                       p,
                       static_cast<Index>(v)});
    std::sort(all.begin(), all.end(), [](const PieceVertex& a, const PieceVertex& b) {
      return std::tie(a.carrier, a.ordinal, a.piece) < std::tie(b.carrier, b.ordinal, b.piece);
    });
    for (const auto& piece : pieces_) merged_.emplace_back(piece.surface.points.size(), -1);
    std::vector<std::size_t> on_edge;  // the vertices of one carrier, once each, in `vertices_`
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_same_carrier = i > 0 && all[i].carrier == all[i - 1].carrier;
      const bool is_same = is_same_carrier && all[i].ordinal == all[i - 1].ordinal;
      if (is_same) {
        require_equal(vertices_.back(), all[i]);
      } else {
        if (!is_same_carrier) on_edge.clear();
        classify(all[i], on_edge);
        on_edge.push_back(vertices_.size());
        vertices_.push_back(all[i]);
      }
      merged_[all[i].piece][as_size(all[i].vertex)] = static_cast<Index>(vertices_.size() - 1);
    }
  }

  const SurfaceMesh& surface_of(const PieceVertex& v) const { return pieces_[v.piece].surface; }

  /// @param before  others with the same carrier and a smaller ordinal
  void classify(PieceVertex& v, const std::vector<std::size_t>& before) const {
    const SurfaceMesh& surface = surface_of(v);
    const auto n = as_size(v.vertex);
    switch (surface.carrier[n]) {
      case Carrier::face:
        v.kind = VertexClass::sample;
        return;
      case Carrier::tet:
        v.kind = VertexClass::inner;
        return;
      case Carrier::vertex:
        v.kind = v.ordinal == 0 ? VertexClass::isotropic : VertexClass::tip;
        return;
      case Carrier::edge:
        break;
    }
    const auto& medium = surface.medium_eigenvector[n];
    v.kind = medium == Vector3<double>{} ? VertexClass::halfway : VertexClass::crossing;
    if (v.kind == VertexClass::halfway) return;
    const auto original = std::find_if(before.begin(), before.end(), [&](std::size_t u) {
      const SurfaceMesh& other = surface_of(vertices_[u]);
      const auto m = as_size(vertices_[u].vertex);
      return same_bits(other.points[m], surface.points[n]) &&
             same_bits(other.medium_eigenvector[m], medium);
    });
    if (original == before.end()) return;
    v.kind = VertexClass::copy;
    v.original = *original;
  }

  void require_equal(const PieceVertex& a, const PieceVertex& b) const {
    const SurfaceMesh &s = surface_of(a), &t = surface_of(b);
    const auto u = as_size(a.vertex), v = as_size(b.vertex);
    if (same_bits(s.points[u], t.points[v]) && same_bits(s.normal[u], t.normal[v]) &&
        same_bits(s.medium_eigenvector[u], t.medium_eigenvector[v]) &&
        same_bits(s.dominant_eigenvector[u], t.dominant_eigenvector[v]) &&
        same_bits(s.residual[u], t.residual[v]) && same_bits(s.mode[u], t.mode[v]) &&
        s.carrier[u] == t.carrier[v])
      return;
    std::array<std::int64_t, 4> ids{-1, -1, -1, -1};
    std::transform(a.carrier.begin(), std::find(a.carrier.begin(), a.carrier.end(), -1),
                   ids.begin(), [&](Index rank) { return id_of(rank); });
    refuse_simplex("they differ", ids);
  }

  std::int64_t id_of(Index rank) const {
    return cells_.vertex_ids[as_size(canonical_.vertices[as_size(rank)])];
  }

  void find_triangles() {
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (std::size_t i = 0; i < pieces_[p].surface.triangles.size(); ++i) {
        const auto t = cells_.first_tet[p] + as_size(pieces_[p].surface.tet[i]);
        triangles_.push_back({tet_rank_[t], p, i});
      }
    std::sort(triangles_.begin(), triangles_.end());
  }

  /// Where a vertex comes first among the corners of triangles. Of a copy: where its first
  /// tetrahedron has its edge.
  std::vector<std::array<std::int64_t, 3>> places() const {
    std::vector<std::array<std::int64_t, 3>> places(vertices_.size(), {-1, -1, -1});
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const auto& [rank, p, triangle] = triangles_[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = as_size(merged_[p][as_size(pieces_[p].surface.triangles[triangle][k])]);
        if (places[v][0] >= 0) continue;
        const auto& vertex = vertices_[v];
        if (vertex.kind == VertexClass::copy) {
          const auto& corners = canonical_.mesh.tets[as_size(rank)];
          const auto corner = [&](Index c) {
            return static_cast<int>(std::find(corners.begin(), corners.end(), c) - corners.begin());
          };
          places[v] = {rank, tet_edge(corner(vertex.carrier[0]), corner(vertex.carrier[1])),
                       vertex.ordinal};
        } else {
          places[v] = {static_cast<std::int64_t>(i), static_cast<std::int64_t>(k), 0};
        }
      }
    }
    return places;
  }

  void number_vertices() {
    const auto place = places();
    order_.resize(vertices_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      const auto &u = vertices_[a], &v = vertices_[b];
      if (u.kind != v.kind || u.kind < VertexClass::copy) return u.key() < v.key();
      return place[a] < place[b];
    });
    number_.resize(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) number_[order_[i]] = static_cast<Index>(i);
  }

  void fill() {
    SurfaceMesh& surface = result_.surface;
    constexpr std::int64_t kLargest = std::numeric_limits<Index>::max();
    const auto short_id = [](std::int64_t id) {
      return id <= kLargest ? static_cast<Index>(id) : Index{-1};
    };
    for (const std::size_t i : order_) {
      const PieceVertex& v = vertices_[i];
      const SurfaceMesh& from = surface_of(v);
      const auto n = as_size(v.vertex);
      surface.points.push_back(from.points[n]);
      surface.carrier.push_back(from.carrier[n]);
      surface.medium_eigenvector.push_back(from.medium_eigenvector[n]);
      surface.dominant_eigenvector.push_back(from.dominant_eigenvector[n]);
      surface.normal.push_back(from.normal[n]);
      surface.mode.push_back(from.mode[n]);
      surface.residual.push_back(from.residual[n]);
      std::array<std::int64_t, 4> ids{-1, -1, -1, -1};
      std::array<Index, 4> carrier{-1, -1, -1, -1};
      std::size_t count = 0;
      for (const Index rank : v.carrier)
        if (rank >= 0) ids[count++] = id_of(rank);
      std::sort(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(count));
      for (std::size_t k = 0; k < count; ++k) carrier[k] = short_id(ids[k]);
      surface.carrier_vertices.push_back(carrier);
      result_.carrier_ids.push_back(ids);
    }
    for (const auto& [rank, p, i] : triangles_) {
      auto corners = pieces_[p].surface.triangles[i];
      for (Index& v : corners) v = number_[as_size(merged_[p][as_size(v)])];
      surface.triangles.push_back(corners);
      const auto id = pieces_[p].cells.cell_ids[as_size(pieces_[p].surface.tet[i])];
      result_.cell_ids.push_back(id);
      surface.tet.push_back(short_id(id));
    }
    surface.component = surface_components(surface);
    for (const auto& piece : pieces_) {
      result_.unresolved.insert(result_.unresolved.end(), piece.unresolved.begin(),
                                piece.unresolved.end());
      result_.not_embedded.insert(result_.not_embedded.end(), piece.not_embedded.begin(),
                                  piece.not_embedded.end());
    }
    std::sort(result_.not_embedded.begin(), result_.not_embedded.end());
    std::sort(result_.unresolved.begin(), result_.unresolved.end(),
              [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
  }

  void fill_cells() {
    result_.cells = cells_.sorted();
    result_.whole_tets = pieces_[0].whole_tets;
    std::vector<std::int64_t> on_level;
    for (const auto& piece : pieces_)
      on_level.insert(on_level.end(), piece.on_level.begin(), piece.on_level.end());
    std::sort(on_level.begin(), on_level.end());
    result_.vertices_on_level =
        static_cast<std::size_t>(std::unique(on_level.begin(), on_level.end()) - on_level.begin());
    for (const auto& piece : pieces_)
      for (const auto& [first, last] : piece.isotropic_ids)
        result_.tets_undefined += as_size(last - first + 1);
    const auto has_topology = [](const PieceSurface& piece) { return piece.topology.has_value(); };
    if (std::all_of(pieces_.begin(), pieces_.end(), has_topology)) fill_topology();
    result_.vertex_ids = std::move(cells_.vertex_ids);
  }

  void fill_topology() {
    const auto rank = cells_.ranks_by_id();
    std::vector<TopologyPart> parts;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const auto first = rank.begin() + static_cast<std::ptrdiff_t>(cells_.first_tet[p]);
      const auto count = static_cast<std::ptrdiff_t>(pieces_[p].cells.tets.size());
      TopologyPart part{
          &*pieces_[p].topology, cells_.vertex_of[p], {first, first + count}, merged_[p]};
      for (Index& v : part.surface_vertices) v = number_[as_size(v)];
      parts.push_back(std::move(part));
    }
    result_.topology = merge_topologies(parts, cells_.vertex_ids);
    for (const std::size_t v : order_)
      if (vertices_[v].kind == VertexClass::copy)
        result_.topology->copies.push_back({number_[vertices_[v].original], number_[v]});
  }

  /// Each side on a seam has a partner, unless what is across was not extracted.
  void check_seams() const {
    std::vector<std::array<Index, 2>> sides;
    for (const auto& [rank, p, i] : triangles_)
      for (std::size_t k = 0; k < 3; ++k)
        if (pieces_[p].ghost_across[i][k] >= 0) sides.push_back(side_of(p, i, k));
    std::sort(sides.begin(), sides.end());
    for (const auto& [rank, p, i] : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t ghost = pieces_[p].ghost_across[i][k];
        if (ghost < 0) continue;
        const auto [from, to] = side_of(p, i, k);
        if (std::binary_search(sides.begin(), sides.end(), std::array{to, from})) continue;
        const auto found = std::lower_bound(
            result_.unresolved.begin(), result_.unresolved.end(), ghost,
            [](const UnresolvedOwnedCell& cell, std::int64_t id) { return cell.cell_id < id; });
        if (found != result_.unresolved.end() && found->cell_id == ghost) continue;
        refuse_sides(pieces_[p].cells.cell_ids[as_size(pieces_[p].surface.tet[i])], ghost);
      }
  }

  std::array<Index, 2> side_of(std::size_t p, std::size_t i, std::size_t k) const {
    const auto& corners = pieces_[p].surface.triangles[i];
    return {number_[as_size(merged_[p][as_size(corners[k])])],
            number_[as_size(merged_[p][as_size(corners[(k + 1) % 3])])]};
  }

  std::span<const PieceSurface> pieces_;
  CrossedCells cells_;
  CanonicalMesh canonical_;
  std::vector<Index> vertex_rank_, tet_rank_;
  std::vector<PieceVertex> vertices_;       ///< of the whole surface, once each
  std::vector<std::vector<Index>> merged_;  ///< of each piece, of its vertices: in `vertices_`
  std::vector<PieceTriangle> triangles_;    ///< in order
  std::vector<std::size_t> order_;          ///< of `vertices_`
  std::vector<Index> number_;               ///< of `vertices_`
  MergedSurface result_;
};

}  // namespace

MergedSurface merge_pieces(std::span<const PieceSurface> pieces) {
  require_all_cells(pieces);
  require_same_messages(pieces);
  return Merger(pieces).run();
}

}  // namespace tensortopo
