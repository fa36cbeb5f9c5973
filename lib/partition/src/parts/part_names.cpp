// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/part_names.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "owned_part.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Id = std::int64_t;

[[noreturn]] void refuse_part(const std::string& text) {
  throw std::invalid_argument("pieces: " + text);
}

}  // namespace

PartNames::PartNames(const std::vector<std::array<Id, 2>>& pairs, const char* what)
    : pairs_(pairs), what_(what) {
  std::sort(pairs_.begin(), pairs_.end());
  std::vector<Id> there;
  for (const auto& [whole, part] : pairs_) {
    if (whole < 0 || part < 0)
      refuse_part("a " + std::string(what) + " of a part has a negative id");
    there.push_back(part);
  }
  std::sort(there.begin(), there.end());
  const auto same = [](const auto& a, const auto& b) { return a[0] == b[0]; };
  if (std::adjacent_find(pairs_.begin(), pairs_.end(), same) != pairs_.end() ||
      std::adjacent_find(there.begin(), there.end()) != there.end())
    refuse_part("a " + std::string(what) + " of a part has the id of another");
}

Id PartNames::of(Id whole) const {
  const auto place = find(whole);
  if (place == pairs_.end())
    refuse_part(std::string(what_) + " " + std::to_string(whole) + " has no number in the part");
  return (*place)[1];
}

std::vector<std::array<Id, 2>>::const_iterator PartNames::find(Id whole) const {
  const auto place = std::lower_bound(pairs_.begin(), pairs_.end(), std::array<Id, 2>{whole, 0});
  return place != pairs_.end() && (*place)[0] == whole ? place : pairs_.end();
}

std::vector<std::array<Id, 2>> part_ids(std::span<const std::array<Id, 2>> owned_ids,
                                        const PartNumbers& numbers) {
  std::vector<Id> ids;
  for (const auto& [whole, part] : numbers.tets) {
    if (!owns(owned_ids, whole))
      refuse_part("cell " + std::to_string(whole) + " of a part is not owned by its piece");
    ids.push_back(part);
  }
  return runs_of(std::move(ids));
}

std::vector<Index> name_cells_anew(TetMesh& cells, std::vector<Id>& vertex_ids,
                                   const PartNames& tets, const PartNames& vertices) {
  std::vector<Id> ids;
  for (const Id id : vertex_ids) ids.push_back(vertices.of(id));
  std::vector<Index> order(ids.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return ids[as_size(a)] < ids[as_size(b)]; });
  std::vector<Index> number = inverse_permutation(order);
  TetMesh named;
  vertex_ids.clear();
  for (const Index v : order) {
    vertex_ids.push_back(ids[as_size(v)]);
    named.points.push_back(cells.points[as_size(v)]);
    named.tensors.push_back(cells.tensors[as_size(v)]);
  }
  named.tets = std::move(cells.tets);
  for (auto& corners : named.tets)
    for (Index& v : corners) v = number[as_size(v)];
  for (const Id id : cells.cell_ids) named.cell_ids.push_back(tets.of(id));
  cells = std::move(named);
  return number;
}

}  // namespace tensortopo
