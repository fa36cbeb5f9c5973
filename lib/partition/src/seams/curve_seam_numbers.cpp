// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <utility>

#include "seams/seam_lists.hpp"
#include "tensortopo/partition/seam_numbers.hpp"

namespace tensortopo {

std::vector<std::int64_t> numbers_of(const CurveSeam& seam) {
  SeamWriter to;
  to.number(seam.kind == Degeneracy::linear ? 0 : 1);
  to.points(seam.cells, seam.vertex_ids);
  to.list(seam.components, [&](const CurveSeam::Component& c) {
    to.number(c.vertices), to.number(c.lines), to.number(c.ends), to.number(c.junctions);
    for (const auto v : c.first_cell) to.number(v);
  });
  to.list(seam.vertices, [&](const CurveSeam::Vertex& v) {
    for (const std::int64_t id : v.carrier_ids) to.number(id);
    to.number(v.ordinal), to.number(v.component), to.number(v.line_ends);
    for (const std::uint64_t hash : {v.owned, v.around, v.digest})
      to.number(std::bit_cast<std::int64_t>(hash));
  });
  to.runs(seam.owned_ids);
  to.number(seam.whole_tets);
  to.messages(seam.told), to.messages(seam.heard);
  return std::move(to.made);
}

CurveSeam curve_seam_of_numbers(std::span<const std::int64_t> numbers) {
  SeamReader from(numbers);
  CurveSeam seam;
  seam.kind = from.index(2) == 0 ? Degeneracy::linear : Degeneracy::planar;
  from.points(seam.cells, seam.vertex_ids);
  from.list(seam.components, [&] {
    CurveSeam::Component c;
    c.vertices = from.number(), c.lines = from.number();
    c.ends = from.number(), c.junctions = from.number();
    for (auto& v : c.first_cell) v = from.index_or_none(seam.vertex_ids.size());
    return c;
  });
  from.list(seam.vertices, [&] {
    CurveSeam::Vertex v;
    for (std::int64_t& id : v.carrier_ids) id = from.number();
    v.ordinal = from.number32(), v.component = from.index(seam.components.size());
    v.line_ends = from.number32();
    for (std::uint64_t* hash : {&v.owned, &v.around, &v.digest})
      *hash = std::bit_cast<std::uint64_t>(from.number());
    return v;
  });
  from.runs(seam.owned_ids);
  seam.whole_tets = from.number();
  from.messages(seam.told), from.messages(seam.heard);
  from.require_end();
  return seam;
}

}  // namespace tensortopo
