// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What seams of surfaces and of curves have in common, as plain numbers.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "number_lists.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

inline std::array<double, 9> doubles_of(const TetMesh& mesh, std::size_t v) {
  const auto& p = mesh.points[v];
  const auto& t = mesh.tensors[v];
  return {p.x, p.y, p.z, t.xx, t.yy, t.zz, t.xy, t.yz, t.xz};
}

/// Reads them.
class SeamReader : public ListReader<std::int64_t> {
 public:
  explicit SeamReader(std::span<const std::int64_t> numbers) : ListReader(numbers, "seam") {}

  double real() { return std::bit_cast<double>(number()); }
  TetMesh::Index index(std::size_t count) { return static_cast<TetMesh::Index>(below(count)); }
  /// -1 is none.
  TetMesh::Index index_or_none(std::size_t count) {
    const std::int64_t n = number();
    if (n < -1 || n >= static_cast<std::int64_t>(count)) refuse();
    return static_cast<TetMesh::Index>(n);
  }
  std::int32_t number32() {
    const std::int64_t n = number();
    if (!std::in_range<std::int32_t>(n)) refuse();
    return static_cast<std::int32_t>(n);
  }
  void ids(std::vector<std::int64_t>& list_of) {
    list(list_of, [&] { return number(); });
  }
  void points(TetMesh& cells, std::vector<std::int64_t>& vertex_ids) {
    ids(vertex_ids);
    for (std::size_t v = 0; v < vertex_ids.size(); ++v) {
      auto& p = cells.points.emplace_back();
      for (double* x : {&p.x, &p.y, &p.z}) *x = real();
      auto& t = cells.tensors.emplace_back();
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = real();
    }
  }
  void runs(std::vector<std::array<std::int64_t, 2>>& list_of) {
    list(list_of, [&] {
      std::array<std::int64_t, 2> run{};
      for (std::int64_t& id : run) id = number();
      return run;
    });
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

/// Writes what seams have.
class SeamWriter : public ListWriter<std::int64_t> {
 public:
  void real(double x) { number(std::bit_cast<std::int64_t>(x)); }
  void ids(const std::vector<std::int64_t>& list_of) {
    list(list_of, [&](std::int64_t id) { number(id); });
  }
  void points(const TetMesh& cells, const std::vector<std::int64_t>& vertex_ids) {
    ids(vertex_ids);
    for (std::size_t v = 0; v < vertex_ids.size(); ++v)
      for (const double x : doubles_of(cells, v)) real(x);
  }
  void runs(const std::vector<std::array<std::int64_t, 2>>& list_of) {
    list(list_of, [&](const auto& run) { number(run[0]), number(run[1]); });
  }
  void messages(const std::vector<PieceMessage>& list_of) {
    list(list_of, [&](const PieceMessage& m) {
      number(m.from_cell), number(m.to_cell), number(m.pass), number(m.round);
      number(std::bit_cast<std::int64_t>(m.digest));
    });
  }
};

}  // namespace tensortopo
