// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/piece_border.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "number_lists.hpp"
#include "streamed/piece_index.hpp"

namespace tensortopo {

namespace {

using Number = std::int64_t;
using Index = TetMesh::Index;

[[noreturn]] void refuse_border(const std::string& text) {
  throw std::invalid_argument("pieces: " + text);
}

void require_one_owner(std::span<const PieceBorder> borders) {
  std::vector<std::tuple<Number, Number, std::size_t>> runs;
  for (std::size_t p = 0; p < borders.size(); ++p)
    for (const auto& [first, last] : borders[p].owned_ids) runs.emplace_back(first, last, p);
  std::sort(runs.begin(), runs.end());
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const auto& [before, last, p] = runs[i - 1];
    const auto& [first, end, q] = runs[i];
    if (first <= last)
      refuse_border("cell " + std::to_string(first) + " is owned by pieces " +
                    std::to_string(std::min(p, q)) + " and " + std::to_string(std::max(p, q)));
  }
}

}  // namespace

PieceBorder border_of(const MeshPiece& piece) {
  require_sound(piece);
  PieceBorder border;
  border.owned_ids = owned_ids_of(piece);
  std::vector<Number> owned(piece.vertex_ids.size(), 0), held(piece.vertex_ids.size(), 0);
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t)
    for (const Index v : piece.mesh.tets[t])
      ++held[as_size(v)], owned[as_size(v)] += piece.is_owned[t] != 0;
  const auto is_outer = outer_vertices(piece.mesh);
  for (std::size_t v = 0; v < owned.size(); ++v)
    if (owned[v] > 0 && (owned[v] != held[v] || is_outer[v] != 0))
      border.vertices.push_back({piece.vertex_ids[v], owned[v], held[v]});
  std::sort(border.vertices.begin(), border.vertices.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  return border;
}

std::vector<Number> numbers_of(const PieceBorder& border) {
  ListWriter<Number> to;
  to.list(border.owned_ids, [&](const auto& run) { to.number(run[0]), to.number(run[1]); });
  to.list(border.vertices, [&](const PieceBorder::Vertex& v) {
    to.number(v.id), to.number(v.owned), to.number(v.held);
  });
  return std::move(to.made);
}

PieceBorder border_of_numbers(std::span<const Number> numbers) {
  ListReader<Number> from(numbers, "border");
  PieceBorder border;
  from.list(border.owned_ids, [&] {
    std::array<Number, 2> run{};
    for (Number& id : run) id = from.number();
    return run;
  });
  from.list(border.vertices, [&] {
    PieceBorder::Vertex v;
    v.id = from.number(), v.owned = from.number(), v.held = from.number();
    return v;
  });
  from.require_end();
  return border;
}

std::int64_t require_one_mesh(std::span<const PieceBorder> borders) {
  require_one_owner(borders);
  std::vector<std::pair<PieceBorder::Vertex, std::size_t>> all;
  Number cells = 0;
  for (std::size_t p = 0; p < borders.size(); ++p) {
    for (const auto& v : borders[p].vertices) all.emplace_back(v, p);
    for (const auto& [first, last] : borders[p].owned_ids) cells += last - first + 1;
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.id, a.second) < std::tie(b.first.id, b.second);
  });
  for (std::size_t i = 0; i < all.size();) {
    std::size_t next = i;
    Number owned = 0;
    while (next < all.size() && all[next].first.id == all[i].first.id)
      owned += all[next++].first.owned;
    for (; i < next; ++i) {
      const auto& [vertex, piece] = all[i];
      const std::string around = " cells around vertex " + std::to_string(vertex.id);
      if (vertex.held < owned)
        refuse_border("piece " + std::to_string(piece) + " has " + std::to_string(vertex.held) +
                      " of the " + std::to_string(owned) + around + ": it needs a layer of ghosts");
      if (vertex.held > owned)
        refuse_border("piece " + std::to_string(piece) + " has " + std::to_string(vertex.held) +
                      around + ", of which " + std::to_string(vertex.held - owned) +
                      " are owned by no piece");
    }
  }
  return cells;
}

}  // namespace tensortopo
