// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/seam_numbers.hpp"

#include <bit>
#include <utility>

#include "seams/seam_lists.hpp"

namespace tensortopo {

namespace {

using Number = std::int64_t;
using Index = TetMesh::Index;

}  // namespace

std::vector<Number> numbers_of(const SurfaceSeam& seam) {
  SeamWriter to;
  to.points(seam.cells, seam.vertex_ids);
  to.list(seam.cells.tets, [&](const auto& corners) {
    for (const Index v : corners) to.number(v);
  });
  for (const Number id : seam.cells.cell_ids) to.number(id);
  to.list(seam.components, [&](const SurfaceSeam::Component& c) {
    to.number(c.vertices), to.number(c.triangles), to.number(c.euler_characteristic);
    to.number(c.closed_borders), to.number(c.first_tet);
  });
  to.list(seam.vertices, [&](const SurfaceSeam::Vertex& v) {
    for (const Number id : v.carrier_ids) to.number(id);
    to.number(v.ordinal), to.number(v.component), to.number(v.border);
    to.number(std::bit_cast<Number>(v.digest));
  });
  to.list(seam.sides, [&](const SurfaceSeam::Side& s) {
    to.number(s.from), to.number(s.to), to.number(s.cell_id), to.number(s.ghost_id);
  });
  to.ids(seam.unresolved);
  to.runs(seam.owned_ids);
  to.number(seam.whole_tets);
  to.messages(seam.told), to.messages(seam.heard);
  return std::move(to.made);
}

SurfaceSeam seam_of_numbers(std::span<const Number> numbers) {
  SeamReader from(numbers);
  SurfaceSeam seam;
  from.points(seam.cells, seam.vertex_ids);
  from.list(seam.cells.tets, [&] {
    std::array<Index, 4> corners{};
    for (Index& v : corners) v = from.index(seam.vertex_ids.size());
    return corners;
  });
  for (std::size_t t = 0; t < seam.cells.tets.size(); ++t)
    seam.cells.cell_ids.push_back(from.number());
  from.list(seam.components, [&] {
    SurfaceSeam::Component c;
    c.vertices = from.number(), c.triangles = from.number();
    c.euler_characteristic = from.number(), c.closed_borders = from.number();
    c.first_tet = from.index(seam.cells.tets.size());
    return c;
  });
  from.list(seam.vertices, [&] {
    SurfaceSeam::Vertex v;
    for (Number& id : v.carrier_ids) id = from.number();
    v.ordinal = from.number32(), v.component = from.index(seam.components.size());
    v.border = from.number32();
    v.digest = std::bit_cast<std::uint64_t>(from.number());
    return v;
  });
  for (const auto& v : seam.vertices)
    if (v.border < -1 || v.border >= static_cast<Number>(seam.vertices.size())) from.refuse();
  from.list(seam.sides, [&] {
    SurfaceSeam::Side s;
    s.from = from.index(seam.vertices.size()), s.to = from.index(seam.vertices.size());
    s.cell_id = from.number(), s.ghost_id = from.number();
    return s;
  });
  from.ids(seam.unresolved);
  from.runs(seam.owned_ids);
  seam.whole_tets = from.number();
  from.messages(seam.told), from.messages(seam.heard);
  from.require_end();
  return seam;
}

}  // namespace tensortopo
