// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/cell_means.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "fields/solid_cells.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/nodal_average.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Tensor = SymmetricTensor<double>;

/// Whether an array on cells tells materials apart, by names that programs give them.
bool may_be_materials(const ArraySource& source) {
  if (source.components != 1) return false;
  std::string name;
  for (const char c : source.name)
    if (c != '_' && c != ' ') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::string_view, 18> known{
      "mat",           "matid",     "objectid",      "elementblockids", "blockid",
      "gmsh:physical", "medit:ref", "cellentityids", "physicalids",     "part",
      "partid",        "region",    "regionid",      "regions",         "domain",
      "domainid",      "subdomain", "elset"};
  return name.find("material") != name.npos ||
         std::find(known.begin(), known.end(), name) != known.end();
}

const ArraySource* find_array(const RawGrid& grid, const std::string& name) {
  for (const ArraySource& source : grid.cell_data)
    if (source.name == name && source.components == 1) return &source;
  return nullptr;
}

}  // namespace

Materials materials_of(const std::vector<RawGrid>& pieces, const ReadOptions& options) {
  if (options.materials == "none") return {};
  const std::filesystem::path& file = pieces.front().file;
  if (options.materials.empty()) {
    std::map<std::string, std::set<double>> values;
    for (const RawGrid& grid : pieces)
      for (const ArraySource& source : grid.cell_data) {
        if (!may_be_materials(source)) continue;
        const std::vector<double> all = source.values();
        for (const std::size_t c : solid_cells(grid)) values[source.name].insert(all[c]);
      }
    for (const auto& [name, found] : values)
      if (found.size() > 1)
        throw IoError(IoError::Kind::invalid, file,
                      "has cells of " + std::to_string(found.size()) + " materials (`" + name +
                          "`), between which tensors jump; --materials " + name +
                          " takes means within each, --materials none over all");
    return {};
  }
  std::map<double, std::size_t> numbers;
  Materials materials;
  for (const RawGrid& grid : pieces) {
    const ArraySource* const source = find_array(grid, options.materials);
    if (source == nullptr)
      throw IoError(
          IoError::Kind::invalid, file,
          "--materials: has no array `" + options.materials + "` of one component on cells");
    std::vector<std::size_t>& of_piece = materials.emplace_back();
    for (const double value : source->values()) {
      if (std::isnan(value))
        throw IoError(
            IoError::Kind::invalid, file,
            "--materials: a value is not a number (cell " + std::to_string(of_piece.size()) + ")");
      of_piece.push_back(numbers.try_emplace(value, numbers.size()).first->second);
    }
  }
  return materials;
}

std::size_t separate_materials(std::vector<RawGrid>& pieces, VertexMap& map,
                               const Materials& materials, TetMesh& mesh) {
  if (materials.empty()) return 0;
  constexpr std::size_t none = SIZE_MAX;
  const std::size_t before = mesh.points.size();
  std::vector<std::size_t> owner(before, none);
  std::map<std::pair<Index, std::size_t>, Index> doubles;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    RawGrid& grid = pieces[k];
    std::map<Index, std::int64_t> point_of;  // the piece's own, of vertices that were added
    for (const std::size_t c : solid_cells(grid))
      for (std::int64_t i = grid.offsets[c]; i < grid.offsets[c + 1]; ++i) {
        std::int64_t& point = grid.connectivity[as_size(i)];
        const Index v = map[k][as_size(point)];
        const std::size_t material = materials[k][c];
        if (owner[as_size(v)] == none) owner[as_size(v)] = material;
        if (owner[as_size(v)] == material) continue;
        const auto [found, is_new] =
            doubles.try_emplace({v, material}, static_cast<Index>(mesh.points.size()));
        if (is_new) {
          if (mesh.points.size() >= INT32_MAX)
            throw IoError(IoError::Kind::invalid, grid.file, "has too many points");
          mesh.points.push_back(mesh.points[as_size(v)]);
          if (!mesh.tensors.empty()) mesh.tensors.push_back(mesh.tensors[as_size(v)]);
        }
        const auto [own, is_first] =
            point_of.try_emplace(found->second, static_cast<std::int64_t>(map[k].size()));
        if (is_first) {
          map[k].push_back(found->second);
          for (std::size_t a = 0; a < 3; ++a)
            grid.coordinates.push_back(grid.coordinates[3 * as_size(point) + a]);
        }
        point = own->second;
      }
  }
  return mesh.points.size() - before;
}

std::size_t average_cells(const std::vector<RawGrid>& pieces, const VertexMap& map,
                          const std::vector<std::vector<Tensor>>& tensors,
                          const TensorChoice& choice, MeanWeights weights, TetMesh& mesh) {
  NodalSums sums(mesh.points.size());
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const std::size_t c : solid_cells(pieces[k])) {
      const RawGrid& grid = pieces[k];
      std::vector<Index> nodes = vertices_of(grid, c, map[k]);
      const double weight =
          weights == MeanWeights::plain ? 1 : cell_volume(mesh, grid.types[c], nodes);
      const std::span<const Tensor> own(tensors[k].data() + c * choice.per_cell, choice.per_cell);
      if (choice.values == CellValues::nodes) {
        if (nodes.size() != choice.per_cell)
          throw IoError(IoError::Kind::invalid, grid.file,
                        "a cell has " + std::to_string(nodes.size()) + " nodes and `" +
                            choice.name + "` " + std::to_string(choice.per_cell) +
                            " tensors for each (cell " + std::to_string(c) + ")");
        sums.add(nodes, own, weight);
      } else {
        nodes.resize(corners_of(grid, c));
        const Tensor mean = plain_mean(own);
        sums.add(nodes, {&mean, 1}, weight);
      }
    }
  mesh.tensors = sums.means();
  std::size_t averaged = 0;
  for (std::size_t v = 0; v < mesh.tensors.size(); ++v) {
    if (!sums.has(v)) continue;
    const Tensor& t = mesh.tensors[v];
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
      if (!std::isfinite(x))
        throw IoError(IoError::Kind::invalid, pieces.front().file,
                      "the tensors around a vertex are too large to average (point " +
                          std::to_string(v) + ")");
    ++averaged;
  }
  return averaged;
}

}  // namespace tensortopo::detail
