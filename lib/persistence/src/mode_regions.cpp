// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/mode_regions.hpp"

#include <map>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

ModeRegions mode_regions(const ContourTree& tree, const PersistenceInput& input) {
  ModeRegions result;
  result.is_complete = tree.is_complete;
  if (tree.has_loops) return result;
  std::vector<int> signs;
  for (const ContourNode& node : tree.nodes) {
    signs.push_back(node.mode.low > 0 ? 1 : node.mode.high < 0 ? -1 : 0);
    result.is_complete &= signs.back() != 0;
  }
  UnionFind classes(tree.nodes.size());
  for (const auto& [upper, lower] : tree.arcs)
    if (signs[upper] == signs[lower])
      classes.unite(static_cast<std::uint32_t>(upper), static_cast<std::uint32_t>(lower));
  std::map<std::uint32_t, std::size_t> numbers;
  const auto region_of = [&](std::size_t node) {
    return numbers.try_emplace(classes.find(static_cast<std::uint32_t>(node)), numbers.size())
        .first->second;
  };
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (signs[i] == 0) continue;
    const std::size_t number = region_of(i);
    if (number == result.regions.size()) result.regions.emplace_back();
    ModeRegion& region = result.regions[number];
    region.sign = signs[i];
    region.nodes.push_back(i);
    const ContourNode& node = tree.nodes[i];
    if (node.maximum && signs[i] > 0)
      if (const auto curve = input.trees[0].maxima[*node.maximum].curve)
        region.curves.push_back(*curve);
    if (node.minimum && signs[i] < 0)
      if (const auto curve = input.trees[1].maxima[*node.minimum].curve)
        region.curves.push_back(*curve);
  }
  for (const auto& [upper, lower] : tree.arcs)
    if (signs[upper] > 0 && signs[lower] < 0)
      result.borders.push_back({region_of(upper), region_of(lower)});
  return result;
}

std::optional<std::vector<std::size_t>> lines_of_closed(const CurveMesh& curves,
                                                        std::size_t component) {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    if (as_size(curves.component[i]) != component) continue;
    if (!lines.empty() && curves.lines[lines.back()].back() != curves.lines[i].front())
      return std::nullopt;
    lines.push_back(i);
  }
  if (lines.empty() || curves.lines[lines.back()].back() != curves.lines[lines.front()].front())
    return std::nullopt;
  return lines;
}

std::optional<std::vector<CurveMesh::Index>> closed_line(const CurveMesh& curves,
                                                         std::size_t component) {
  const auto lines = lines_of_closed(curves, component);
  if (!lines) return std::nullopt;
  // The last vertex of a line is the first one of the next.
  std::vector<CurveMesh::Index> vertices;
  for (const std::size_t i : *lines)
    vertices.insert(vertices.end(), curves.lines[i].begin(), curves.lines[i].end() - 1);
  if (vertices.size() < 3) return std::nullopt;
  return vertices;
}

}  // namespace tensortopo
