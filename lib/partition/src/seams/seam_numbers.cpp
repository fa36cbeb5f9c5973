// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/seam_numbers.hpp"

#include <array>
#include <bit>
#include <utility>

#include "number_lists.hpp"

namespace tensortopo {

namespace {

using Number = std::int64_t;
using Index = TetMesh::Index;

std::array<double, 9> doubles_of(const TetMesh& mesh, std::size_t v) {
  const auto& p = mesh.points[v];
  const auto& t = mesh.tensors[v];
  return {p.x, p.y, p.z, t.xx, t.yy, t.zz, t.xy, t.yz, t.xz};
}

class SeamReader : public ListReader<Number> {
 public:
  explicit SeamReader(std::span<const Number> numbers) : ListReader(numbers, "seam") {}

  double real() { return std::bit_cast<double>(number()); }
  Index index(std::size_t count) { return static_cast<Index>(below(count)); }
  std::int32_t number32() {
    const Number n = number();
    if (!std::in_range<std::int32_t>(n)) refuse();
    return static_cast<std::int32_t>(n);
  }
  void ids(std::vector<Number>& list_of) {
    list(list_of, [&] { return number(); });
  }
  void messages(std::vector<PieceMessage>& list_of) {
    list(list_of, [&] {
      PieceMessage m;
      m.from_cell = number(), m.to_cell = number();
      m.pass = number32(), m.round = number32();
      m.digest = std::bit_cast<std::uint64_t>(number());
      return m;
    });
  }
};

class SeamWriter : public ListWriter<Number> {
 public:
  void real(double x) { number(std::bit_cast<Number>(x)); }
  void ids(const std::vector<Number>& list_of) {
    list(list_of, [&](Number id) { number(id); });
  }
  void messages(const std::vector<PieceMessage>& list_of) {
    list(list_of, [&](const PieceMessage& m) {
      number(m.from_cell), number(m.to_cell), number(m.pass), number(m.round);
      number(std::bit_cast<Number>(m.digest));
    });
  }
};

}  // namespace

std::vector<Number> numbers_of(const SurfaceSeam& seam) {
  SeamWriter to;
  to.ids(seam.vertex_ids);
  for (std::size_t v = 0; v < seam.vertex_ids.size(); ++v)
    for (const double x : doubles_of(seam.cells, v)) to.real(x);
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
  to.list(seam.owned_ids, [&](const auto& run) { to.number(run[0]), to.number(run[1]); });
  to.number(seam.whole_tets);
  to.messages(seam.told), to.messages(seam.heard);
  return std::move(to.made);
}

SurfaceSeam seam_of_numbers(std::span<const Number> numbers) {
  SeamReader from(numbers);
  SurfaceSeam seam;
  from.ids(seam.vertex_ids);
  for (std::size_t v = 0; v < seam.vertex_ids.size(); ++v) {
    auto& p = seam.cells.points.emplace_back();
    for (double* x : {&p.x, &p.y, &p.z}) *x = from.real();
    auto& t = seam.cells.tensors.emplace_back();
    for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = from.real();
  }
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
  from.list(seam.owned_ids, [&] {
    std::array<Number, 2> run{};
    for (Number& id : run) id = from.number();
    return run;
  });
  seam.whole_tets = from.number();
  from.messages(seam.told), from.messages(seam.heard);
  from.require_end();
  return seam;
}

}  // namespace tensortopo
