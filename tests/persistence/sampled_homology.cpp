// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sampled_homology.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Simplex = std::array<int, 4>;  // vertices, ascending; the last ones -1
using Column = std::vector<std::size_t>;

/// The rows that are in one of the columns.
Column added(const Column& a, const Column& b) {
  Column sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

Simplex simplex_of(const TetMesh& mesh, std::size_t tet, unsigned subset) {
  Simplex simplex{-1, -1, -1, -1};
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i)
    if ((subset >> i & 1U) != 0) simplex[count++] = mesh.tets[tet][i];
  std::sort(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(count));
  return simplex;
}

/// The simplices of a dimension, and in which order they appear.
struct Simplices {
  std::vector<Simplex> all;        ///< ascending
  std::vector<double> births;      ///< of each in order of appearance
  std::vector<std::size_t> order;  ///< those that appear, one after the other
  std::vector<std::size_t> rank;   ///< the inverse

  void sort(const std::vector<double>& value) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<double> born;
    for (const Simplex& s : all) {
      born.push_back(1);
      for (const int v : s)
        if (v >= 0) born.back() = std::min(born.back(), value[static_cast<std::size_t>(v)]);
    }
    order.resize(all.size());
    rank.resize(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return born[a] > born[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      rank[order[i]] = i;
      births.push_back(born[order[i]]);
    }
  }
  std::size_t place_of(const Simplex& s) const {
    return rank[static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), s) -
                                         all.begin())];
  }
};

/// Faces of a simplex, as they are numbered by appearance, ascending.
Column boundary_of(const Simplex& simplex, std::size_t dimension, const Simplices& faces) {
  Column column;
  for (std::size_t k = 0; k <= dimension; ++k) {
    Simplex face{-1, -1, -1, -1};
    std::size_t count = 0;
    for (std::size_t i = 0; i <= dimension; ++i)
      if (i != k) face[count++] = simplex[i];
    column.push_back(faces.place_of(face));
  }
  std::sort(column.begin(), column.end());
  return column;
}

}  // namespace

SampledHomology sampled_homology(TetMesh mesh, int cuts, bool is_opposite) {
  for (int i = 0; i < cuts; ++i) mesh = subdivide(mesh);
  SampledHomology result;
  const double sign = is_opposite ? -1 : 1;
  std::vector<double> value;
  std::vector<Deviator<double>> tensors;
  const auto angle_of = [&](const Deviator<double>& t) {
    return sign * (std::numbers::pi / 6 - lode_angle(t));
  };
  for (const auto& t : mesh.tensors) {
    tensors.push_back(deviator(t));
    value.push_back(angle_of(tensors.back()));
  }
  std::array<Simplices, 4> simplices;
  for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
    for (unsigned subset = 1; subset < 16; ++subset) {
      const auto dimension = static_cast<std::size_t>(__builtin_popcount(subset)) - 1;
      simplices[dimension].all.push_back(simplex_of(mesh, tet, subset));
    }
  for (Simplices& list : simplices) list.sort(value);
  for (const Simplex& edge : simplices[1].all) {
    const auto v = static_cast<std::size_t>(edge[0]), w = static_cast<std::size_t>(edge[1]);
    const double between = angle_of(tensors[v] + tensors[w]);
    result.error = std::max(result.error, 2 * std::abs(between - (value[v] + value[w]) / 2));
  }
  // From the largest dimension down: what is a boundary has none itself.
  std::array<std::vector<char>, 4> is_paired;
  for (std::size_t d = 0; d < 4; ++d) is_paired[d].assign(simplices[d].all.size(), 0);
  for (std::size_t d = 3; d > 0; --d) {
    const Simplices &here = simplices[d], &faces = simplices[d - 1];
    std::vector<Column> by_lowest(faces.all.size());
    for (std::size_t i = 0; i < here.all.size(); ++i) {
      if (is_paired[d][i] != 0) continue;
      Column column = boundary_of(here.all[here.order[i]], d, faces);
      while (!column.empty() && !by_lowest[column.back()].empty())
        column = added(column, by_lowest[column.back()]);
      if (column.empty()) continue;
      const std::size_t low = column.back();
      is_paired[d][i] = is_paired[d - 1][low] = 1;
      if (faces.births[low] > here.births[i])
        result.pairs[d - 1].push_back({faces.births[low], here.births[i]});
      by_lowest[low] = std::move(column);
    }
  }
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < is_paired[d].size(); ++i)
      if (is_paired[d][i] == 0) result.pairs[d].push_back({simplices[d].births[i], -2});
  return result;
}

}  // namespace tensortopo::test
