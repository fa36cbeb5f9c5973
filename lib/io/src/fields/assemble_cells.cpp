// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/assemble_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bytes/format_error.hpp"
#include "grids/cell_kind.hpp"
#include "fields/quadratic_cells.hpp"
#include "fields/solid_cells.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Use = CellKind::Use;

/// Cells that cannot be taken: how many of each type, and the first.
class Refusals {
 public:
  void add(std::uint8_t type, std::size_t cell) {
    auto [entry, is_new] = types_.try_emplace(type, 0, cell);
    ++entry->second.first;
  }

  void check(const RawGrid& grid) const {
    if (types_.empty()) return;
    std::string text;
    bool curable = true;
    std::size_t first = SIZE_MAX;
    for (const auto& [type, seen] : types_) {
      const CellKind kind = cell_kind(type);
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", seen.first, kind.name);
      if (kind.use == Use::unknown) text += fmt::format(" {}", type);
      curable = curable && kind.use == Use::split;
      first = std::min(first, seen.second);
    }
    throw IoError(IoError::Kind::invalid, grid.file,
                  "has cells that are no linear tetrahedra: " + text + " (the first is cell " +
                      std::to_string(first) + ")" +
                      (curable ? "; --tetrahedralize splits them"
                               : "; ParaView's filter Tetrahedralize makes tetrahedra of them"));
  }

 private:
  std::map<std::uint8_t, std::pair<std::size_t, std::size_t>> types_;
};

class Assembly {
 public:
  Assembly(const ReadOptions& options, QuadraticCells quadratic_use, TetMesh& mesh,
           ReadReport& report)
      : options_(options),
        quadratic_use_(quadratic_use),
        mesh_(mesh),
        report_(report),
        quadratic_(mesh) {}

  /// @param taken  of each cell, whether it is; empty for all
  void add(const RawGrid& grid, const std::vector<Index>& vertices,
           const std::vector<char>& taken) {
    const std::vector<char> ghosts = ghost_cells(grid);
    Refusals refusals;
    std::vector<Index> corners;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
      const CellKind kind = cell_kind(grid.types[c]);
      if (!ghosts.empty() && ghosts[c] != 0) {
        ++report_.skipped_ghost_cells;
      } else if (kind.use == Use::skip) {
        ++report_.skipped_cells_2d_1d;
      } else if (!taken.empty() && taken[c] == 0) {
        ++report_.cells_left_out;
      } else if (quadratic_kind(grid.types[c]).nodes > 0) {
        vertices_of(grid, c, vertices, corners);
        take_quadratic(grid, c, corners, static_cast<std::int64_t>(first_cell_ + c));
      } else if (kind.use != Use::tetrahedron &&
                 (kind.use != Use::split || !(options_.tetrahedralize || grid.is_regular))) {
        refusals.add(grid.types[c], c);
      } else {
        vertices_of(grid, c, vertices, corners);
        if (corners.size() != kind.corners)
          throw IoError(IoError::Kind::invalid, grid.file,
                        "a cell has " + std::to_string(corners.size()) + " corners where " +
                            std::to_string(kind.corners) + " belong (cell " + std::to_string(c) +
                            ")");
        take(grid.types[c], corners, static_cast<std::int64_t>(first_cell_ + c));
      }
    }
    refusals.check(grid);
    first_cell_ += grid.cells();
  }

  void count_vertices() {
    report_.added_vertices = quadratic_.added_vertices();
    report_.curved_edges = quadratic_.curved_edges();
  }

  /// Gives all tetrahedra positive volume; those of split cells are no news.
  void orient() {
    const bool some_split = report_.split_cells > 0;
    const auto before = some_split ? mesh_.tets : std::vector<std::array<Index, 4>>{};
    report_.reoriented_cells = repair_orientation(mesh_);
    if (!some_split) return;
    report_.reoriented_cells = 0;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      report_.reoriented_cells += !from_split_[t] && mesh_.tets[t] != before[t] ? 1u : 0u;
  }

 private:
  /// Leaves the corners alone in `nodes` if it takes the cell by them.
  void take_quadratic(const RawGrid& grid, std::size_t cell, std::vector<Index>& nodes,
                      std::int64_t id) {
    const std::uint8_t type = grid.types[cell];
    const QuadraticKind kind = quadratic_kind(type);
    const std::string place = " (cell " + std::to_string(cell) + ")";
    if (nodes.size() != kind.nodes)
      throw IoError(IoError::Kind::invalid, grid.file,
                    "a quadratic cell has " + std::to_string(nodes.size()) + " nodes where " +
                        std::to_string(kind.nodes) + " belong" + place);
    ++report_.quadratic_cells;
    quadratic_.count_curved(type, nodes);
    if (quadratic_use_ == QuadraticCells::split) {
      const std::size_t before = mesh_.tets.size();
      naming_file(grid.file, "cell " + std::to_string(cell),
                  [&] { quadratic_.split(type, nodes, mesh_.tets); });
      ++report_.split_cells;
      mesh_.cell_ids.insert(mesh_.cell_ids.end(), mesh_.tets.size() - before, id);
      from_split_.resize(mesh_.tets.size(), true);
    } else {
      nodes.resize(kind.corners);
      take(kind.linear_type, nodes, id);
      from_split_.resize(mesh_.tets.size(), cell_kind(kind.linear_type).use == Use::split);
    }
  }

  void take(std::uint8_t type, const std::vector<Index>& corners, std::int64_t id) {
    const std::size_t before = mesh_.tets.size();
    const bool split = cell_kind(type).use == Use::split;
    if (split) {
      split_cell(type, corners, mesh_.tets);
      ++report_.split_cells;
    } else {
      mesh_.tets.push_back({corners[0], corners[1], corners[2], corners[3]});
    }
    mesh_.cell_ids.insert(mesh_.cell_ids.end(), mesh_.tets.size() - before, id);
    from_split_.resize(mesh_.tets.size(), split);
  }

  const ReadOptions& options_;
  QuadraticCells quadratic_use_;
  TetMesh& mesh_;
  ReadReport& report_;
  std::size_t first_cell_ = 0;
  QuadraticSplitter quadratic_;
  std::vector<char> from_split_;  // for each tetrahedron
};

}  // namespace

void assemble_cells(const std::vector<RawGrid>& pieces, const VertexMap& map,
                    const CellSelection& selection, QuadraticCells quadratic,
                    const ReadOptions& options, TetMesh& mesh, ReadReport& report) {
  Assembly assembly(options, quadratic, mesh, report);
  std::size_t cells = 0;  // nearly always all of them tetrahedra
  for (const RawGrid& grid : pieces) cells += grid.cells();
  mesh.tets.reserve(cells);
  mesh.cell_ids.reserve(cells);
  for (std::size_t k = 0; k < pieces.size(); ++k) 
    assembly.add(pieces[k], map[k], selection.empty() ? std::vector<char>() : selection[k]);
  assembly.count_vertices();
  assembly.orient();
}

}  // namespace tensortopo::detail
