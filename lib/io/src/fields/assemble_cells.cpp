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
#include "fields/cell_kind.hpp"
#include "fields/quadratic_cells.hpp"
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
                      (curable ? "; --tetrahedralize splits them" : ""));
  }

 private:
  std::map<std::uint8_t, std::pair<std::size_t, std::size_t>> types_;
};

/// Marks of `vtkGhostType` for a cell that belongs to another piece, or is blanked.
bool is_ghost(double mark) {
  constexpr unsigned duplicate = 1, hidden = 32;
  return mark > 0 && mark < 256 && (static_cast<unsigned>(mark) & (duplicate | hidden)) != 0;
}

class Assembly {
 public:
  Assembly(const ReadOptions& options, TetMesh& mesh, ReadReport& report)
      : options_(options),
        mesh_(mesh),
        report_(report),
        quadratic_(mesh, mesh.tensors.size() == mesh.points.size() && !mesh.points.empty()) {}

  void add(const RawGrid& grid, const std::vector<Index>& vertices,
           const std::vector<SymmetricTensor<double>>& on_cells) {
    std::vector<double> ghosts;
    for (const ArraySource& source : grid.cell_data)
      if (source.name == "vtkGhostType" && source.components == 1) ghosts = source.values();
    Refusals refusals;
    std::vector<Index> corners;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
      const CellKind kind = cell_kind(grid.types[c]);
      if (!ghosts.empty() && is_ghost(ghosts[c])) {
        ++report_.skipped_ghost_cells;
      } else if (kind.use == Use::skip) {
        ++report_.skipped_cells_2d_1d;
      } else if (quadratic_kind(grid.types[c]).nodes > 0) {
        corners.clear();
        for (std::int64_t i = grid.offsets[c]; i < grid.offsets[c + 1]; ++i)
          corners.push_back(
              vertices[static_cast<std::size_t>(grid.connectivity[static_cast<std::size_t>(i)])]);
        const auto id = static_cast<std::int64_t>(first_cell_ + c);
        take_quadratic(grid, c, corners, id, on_cells.empty());
        if (!on_cells.empty()) average(corners, on_cells[c]);
      } else if (kind.use != Use::tetrahedron &&
                 (kind.use != Use::split || !options_.tetrahedralize)) {
        refusals.add(grid.types[c], c);
      } else {
        corners.clear();
        for (std::int64_t i = grid.offsets[c]; i < grid.offsets[c + 1]; ++i)
          corners.push_back(
              vertices[static_cast<std::size_t>(grid.connectivity[static_cast<std::size_t>(i)])]);
        if (corners.size() != kind.corners)
          throw IoError(IoError::Kind::invalid, grid.file,
                        "a cell has " + std::to_string(corners.size()) + " corners where " +
                            std::to_string(kind.corners) + " belong (cell " + std::to_string(c) +
                            ")");
        take(grid.types[c], corners, static_cast<std::int64_t>(first_cell_ + c));
        if (!on_cells.empty()) average(corners, on_cells[c]);
      }
    }
    refusals.check(grid);
    first_cell_ += grid.cells();
  }

  /// Divides the sums of cell tensors by their numbers.
  void finish_averages(const std::filesystem::path& file) {
    mesh_.tensors.resize(mesh_.points.size());
    sums_.resize(mesh_.points.size());
    numbers_.resize(mesh_.points.size());
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      if (numbers_[v] == 0) continue;
      const SymmetricTensor<double>& s = sums_[v];
      const double n = static_cast<double>(numbers_[v]);
      mesh_.tensors[v] = {s.xx / n, s.yy / n, s.zz / n, s.xy / n, s.yz / n, s.xz / n};
      for (const double x : {s.xx, s.yy, s.zz, s.xy, s.yz, s.xz})
        if (!std::isfinite(x))
          throw IoError(IoError::Kind::invalid, file,
                        "the tensors around a vertex are too large to average (point " +
                            std::to_string(v) + ")");
      ++report_.averaged_vertices;
    }
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
                      std::int64_t id, bool may_split) {
    const std::uint8_t type = grid.types[cell];
    const QuadraticKind kind = quadratic_kind(type);
    if (options_.for_certificate)
      throw IoError(IoError::Kind::inapplicable, grid.file,
                    "has quadratic cells (cell " + std::to_string(cell) +
                        "), which the checker of certificates does not read; write it anew with "
                        "tensortopo convert");
    const std::string place = " (cell " + std::to_string(cell) + ")";
    if (nodes.size() != kind.nodes)
      throw IoError(IoError::Kind::invalid, grid.file,
                    "a quadratic cell has " + std::to_string(nodes.size()) + " nodes where " +
                        std::to_string(kind.nodes) + " belong" + place);
    ++report_.quadratic_cells;
    quadratic_.count_curved(type, nodes);
    if (may_split && options_.quadratic == QuadraticCells::split) {
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

  void average(const std::vector<Index>& corners, const SymmetricTensor<double>& tensor) {
    sums_.resize(mesh_.points.size());
    numbers_.resize(mesh_.points.size());
    for (auto v = corners.begin(); v != corners.end(); ++v) {
      if (std::find(corners.begin(), v, *v) != v) continue;  // a corner listed twice counts once
      auto& sum = sums_[static_cast<std::size_t>(*v)];
      sum = sum + tensor;
      ++numbers_[static_cast<std::size_t>(*v)];
    }
  }

  const ReadOptions& options_;
  TetMesh& mesh_;
  ReadReport& report_;
  std::size_t first_cell_ = 0;
  QuadraticSplitter quadratic_;
  std::vector<char> from_split_;  // for each tetrahedron
  std::vector<SymmetricTensor<double>> sums_;
  std::vector<std::size_t> numbers_;
};

}  // namespace

void assemble_cells(const std::vector<RawGrid>& pieces, const VertexMap& map,
                    const std::vector<std::vector<SymmetricTensor<double>>>& on_cells,
                    const ReadOptions& options, TetMesh& mesh, ReadReport& report) {
  Assembly assembly(options, mesh, report);
  std::size_t cells = 0;  // nearly always all of them tetrahedra
  for (const RawGrid& grid : pieces) cells += grid.cells();
  mesh.tets.reserve(cells);
  mesh.cell_ids.reserve(cells);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    assembly.add(pieces[k], map[k],
                 on_cells.empty() ? std::vector<SymmetricTensor<double>>{} : on_cells[k]);
  if (!on_cells.empty()) assembly.finish_averages(pieces.front().file);
  assembly.count_vertices();
  assembly.orient();
}

}  // namespace tensortopo::detail
