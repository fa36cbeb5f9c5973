// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "crossed_cells.hpp"
#include "curves/line_order.hpp"
#include "curves/piece_vertices.hpp"
#include "differing_pieces.hpp"
#include "extract/curves/curve_graph.hpp"
#include "piece_messages.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// A vertex of the curves of one of the pieces.
struct CurveVertex {
  std::size_t piece, vertex;
};

/// An end of lines.
struct LineEnd {
  CurveVertexKind kind{};
  std::array<Index, 4> carrier{};  ///< in canonical numbers, ascending; -1 fills up
  std::int32_t ordinal = 0;
  CurveVertex at{};

  auto key() const { return std::tie(kind, carrier, ordinal); }
};

/// A line of one of the pieces.
struct PieceLine {
  CellOrder cell;
  std::int32_t ordinal = 0;
  std::size_t piece = 0, line = 0;
  auto operator<=>(const PieceLine&) const = default;
};

class CurveMerger {
 public:
  explicit CurveMerger(std::span<const PieceCurves> pieces)
      : pieces_(pieces),
        cells_(crossed_cells(pieces)),
        canonical_(canonical_mesh(cells_.mesh)),
        vertex_rank_(inverse_permutation(canonical_.vertices)) {}

  MergedCurves run() {
    find_ends();
    find_lines();
    number_vertices();
    add_lines();
    add_cells();
    return std::move(result_);
  }

 private:
  /// In canonical numbers.
  std::array<Index, 4> ranks(std::size_t piece, std::array<Index, 4> simplex) const {
    return ranks_of(in_all_cells(piece, simplex), vertex_rank_);
  }
  std::array<Index, 4> in_all_cells(std::size_t piece, std::array<Index, 4> simplex) const {
    for (Index& v : simplex)
      if (v >= 0) v = cells_.vertex_of[piece][as_size(v)];
    return simplex;
  }

  /// All ends of lines, once each, in the order of the whole.
  void find_ends() {
    std::vector<LineEnd> all;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const PieceCurves& piece = pieces_[p];
      number_.emplace_back(piece.curves.points.size(), -1);
      own_.push_back(lines_around(piece.curves, piece.cells.cell_ids));
      for (std::size_t v = 0; v < piece.keys.vertices.size(); ++v) {
        const auto& [kind, ordinal] = piece.keys.vertices[v];
        if (kind != CurveVertexKind::between_ends)
          all.push_back({kind, ranks(p, piece.curves.carrier_vertices[v]), ordinal, {p, v}});
      }
    }
    std::sort(all.begin(), all.end(), [](const LineEnd& a, const LineEnd& b) {
      return std::tuple_cat(a.key(), std::tie(a.at.piece)) <
             std::tuple_cat(b.key(), std::tie(b.at.piece));
    });
    for (std::size_t i = 0; i < all.size();) {
      std::size_t next = i;
      std::uint64_t owned = 0;
      for (; next < all.size() && all[next].key() == all[i].key(); ++next) {
        const auto& [p, v] = all[next].at;
        owned += own_[p][v];
        number_[p][v] = static_cast<Index>(vertices_.size());
      }
      for (std::size_t k = i; k < next; ++k) require_same_end(all[i], all[k], owned);
      vertices_.push_back(all[i].at);
      i = next;
    }
  }

  /// @param owned  of the lines at the end that all pieces own
  void require_same_end(const LineEnd& a, const LineEnd& b, std::uint64_t owned) const {
    const CurveMesh &s = pieces_[a.at.piece].curves, &t = pieces_[b.at.piece].curves;
    const std::size_t u = a.at.vertex, v = b.at.vertex;
    if (pieces_[b.at.piece].around[v] == owned && same_bits(s.points[u], t.points[v]) &&
        same_bits(s.dominant_eigenvector[u], t.dominant_eigenvector[v]) &&
        same_bits(s.mode[u], t.mode[v]) && same_bits(s.separation[u], t.separation[v]) &&
        same_bits(s.residual[u], t.residual[v]) && s.carrier[u] == t.carrier[v])
      return;
    refuse_simplex("curves differ", ids_of(a.carrier));
  }

  /// Ascending; -1 fills up.
  std::array<std::int64_t, 4> ids_of(const std::array<Index, 4>& carrier) const {
    std::array<std::int64_t, 4> ids{-1, -1, -1, -1};
    const auto end = std::transform(
        carrier.begin(), std::find(carrier.begin(), carrier.end(), -1), ids.begin(),
        [&](Index rank) { return cells_.vertex_ids[as_size(canonical_.vertices[as_size(rank)])]; });
    std::sort(ids.begin(), end);
    return ids;
  }

  void find_lines() {
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (std::size_t i = 0; i < pieces_[p].keys.lines.size(); ++i) {
        const auto& key = pieces_[p].keys.lines[i];
        lines_.push_back(
            {order_of_cell(in_all_cells(p, key.cell), vertex_rank_), key.ordinal, p, i});
      }
    std::sort(lines_.begin(), lines_.end());
    for (std::size_t i = 1; i < lines_.size(); ++i)
      if (lines_[i].cell == lines_[i - 1].cell && lines_[i].piece != lines_[i - 1].piece)
        refuse_simplex("two pieces have the lines", ids_of(lines_[i].cell.ranks));
  }

  /// The vertices of a line in the direction in which its cell gives it.
  std::vector<Index> vertices_of(const PieceLine& line) const {
    const PieceCurves& piece = pieces_[line.piece];
    std::vector<Index> vertices = piece.curves.lines[line.line];
    if (piece.keys.lines[line.line].is_reversed) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }

  /// Ends come first, then what is between them.
  void number_vertices() {
    for (const PieceLine& line : lines_) {
      const auto vertices = vertices_of(line);
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        const auto v = as_size(vertices[k]);
        number_[line.piece][v] = static_cast<Index>(vertices_.size());
        vertices_.push_back({line.piece, v});
      }
    }
    constexpr std::int64_t kLargest = std::numeric_limits<Index>::max();
    CurveMesh& curves = result_.curves;
    for (const auto& [p, v] : vertices_) {
      const CurveMesh& from = pieces_[p].curves;
      curves.points.push_back(from.points[v]);
      curves.carrier.push_back(from.carrier[v]);
      curves.dominant_eigenvector.push_back(from.dominant_eigenvector[v]);
      curves.mode.push_back(from.mode[v]);
      curves.separation.push_back(from.separation[v]);
      curves.residual.push_back(from.residual[v]);
      const auto ids = ids_of(ranks(p, from.carrier_vertices[v]));
      result_.carrier_ids.push_back(ids);
      auto& carrier = curves.carrier_vertices.emplace_back();
      std::transform(ids.begin(), ids.end(), carrier.begin(), [&](std::int64_t id) {
        return id <= kLargest ? static_cast<Index>(id) : Index{-1};
      });
    }
  }

  /// In the order and the directions in which the components are run through.
  void add_lines() {
    std::vector<CurveLink> links(lines_.size());
    std::size_t ends = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto vertices = vertices_of(lines_[i]);
      const auto number = [&](Index v) { return as_size(number_[lines_[i].piece][as_size(v)]); };
      links[i].ends = {number(vertices.front()), number(vertices.back())};
      ends = std::max({ends, links[i].ends[0] + 1, links[i].ends[1] + 1});
    }
    const auto components = CurveGraph(links, ends).components();
    for (std::size_t c = 0; c < components.size(); ++c)
      for (const CurveStep& step : components[c]) add_line(step, static_cast<Index>(c));
  }

  void add_line(const CurveStep& step, Index component) {
    constexpr std::int64_t kLargest = std::numeric_limits<Index>::max();
    const PieceLine& line = lines_[step.link];
    auto vertices = vertices_of(line);
    for (Index& v : vertices) v = number_[line.piece][as_size(v)];
    if (step.from == 1) std::reverse(vertices.begin(), vertices.end());
    result_.curves.lines.push_back(std::move(vertices));
    const PieceCurves& piece = pieces_[line.piece];
    const auto id = piece.cells.cell_ids[as_size(piece.curves.tet[line.line])];
    result_.cell_ids.push_back(id);
    result_.curves.tet.push_back(id <= kLargest ? static_cast<Index>(id) : Index{-1});
    result_.curves.component.push_back(component);
  }

  void add_cells() {
    for (const auto list : {&PieceCurves::unresolved, &PieceCurves::special}) {
      auto& all = list == &PieceCurves::unresolved ? result_.unresolved : result_.special;
      for (const PieceCurves& piece : pieces_)
        all.insert(all.end(), (piece.*list).begin(), (piece.*list).end());
      std::sort(all.begin(), all.end(),
                [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
    }
    result_.cells = cells_.sorted();
    result_.vertex_ids = std::move(cells_.vertex_ids);
    result_.kind = pieces_[0].kind;
    result_.whole_tets = pieces_[0].whole_tets;
  }

  std::span<const PieceCurves> pieces_;
  CrossedCells cells_;
  CanonicalMesh canonical_;
  std::vector<Index> vertex_rank_;
  std::vector<std::vector<std::uint64_t>> own_;  ///< of each piece and vertex: see `lines_around`
  std::vector<std::vector<Index>> number_;       ///< of each piece and vertex: in `vertices_`
  std::vector<CurveVertex> vertices_;            ///< of the whole curves, in order
  std::vector<PieceLine> lines_;                 ///< in the order of their cells
  MergedCurves result_;
};

}  // namespace

CurveMesh curves_in_cells(const MergedCurves& merged) {
  CurveMesh curves = merged.curves;
  const auto place = [](const std::vector<std::int64_t>& ids, std::int64_t id) {
    return static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
  for (std::size_t i = 0; i < curves.tet.size(); ++i)
    curves.tet[i] = place(merged.cells.cell_ids, merged.cell_ids[i]);
  for (std::size_t v = 0; v < curves.points.size(); ++v)
    for (std::size_t k = 0; k < 4; ++k)
      if (const std::int64_t id = merged.carrier_ids[v][k]; id >= 0)
        curves.carrier_vertices[v][k] = place(merged.vertex_ids, id);
  return curves;
}

MergedCurves merge_curve_pieces(std::span<const PieceCurves> pieces) {
  require_all_cells(pieces);
  require_one_kind(pieces);
  require_same_messages(pieces);
  return CurveMerger(pieces).run();
}

}  // namespace tensortopo
