// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sampled_homology.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Simplex = std::vector<int>;  // vertices, ascending
using Column = std::vector<std::size_t>;

/// The column with the same rows once more taken out.
Column added(const Column& a, const Column& b) {
  Column sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

}  // namespace

SampledHomology sampled_homology(TetMesh mesh, int cuts, bool is_opposite) {
  for (int i = 0; i < cuts; ++i) mesh = subdivide(mesh);
  SampledHomology result;
  std::vector<double> value;
  std::vector<Deviator<double>> tensors;
  for (const auto& t : mesh.tensors) {
    tensors.push_back(deviator(t));
    const double angle = std::numbers::pi / 6 - lode_angle(tensors.back());
    value.push_back(is_opposite ? -angle : angle);
  }
  std::array<std::map<Simplex, std::size_t>, 4> places;
  std::array<std::vector<Simplex>, 4> simplices;
  for (const auto& tet : mesh.tets)
    for (unsigned subset = 1; subset < 16; ++subset) {
      Simplex simplex;
      for (unsigned i = 0; i < 4; ++i)
        if ((subset >> i & 1U) != 0) simplex.push_back(tet[i]);
      std::sort(simplex.begin(), simplex.end());
      places[simplex.size() - 1].try_emplace(simplex, 0);
    }
  const auto born = [&](const Simplex& s) {
    double least = 1;
    for (const int v : s) least = std::min(least, value[static_cast<std::size_t>(v)]);
    return least;
  };
  std::array<std::vector<double>, 4> births;
  for (std::size_t d = 0; d < 4; ++d) {
    for (const auto& [simplex, place] : places[d]) simplices[d].push_back(simplex);
    std::stable_sort(simplices[d].begin(), simplices[d].end(),
                     [&](const Simplex& a, const Simplex& b) { return born(a) > born(b); });
    for (std::size_t i = 0; i < simplices[d].size(); ++i) {
      places[d][simplices[d][i]] = i;
      births[d].push_back(born(simplices[d][i]));
    }
  }
  for (const auto& edge : simplices[1]) {
    const auto v = static_cast<std::size_t>(edge[0]), w = static_cast<std::size_t>(edge[1]);
    const double sign = is_opposite ? -1 : 1;
    const double between = sign * (std::numbers::pi / 6 - lode_angle(tensors[v] + tensors[w]));
    result.error = std::max(result.error, 2 * std::abs(between - (value[v] + value[w]) / 2));
  }
  // From the largest dimension down: what a column kills bounds nothing itself.
  std::array<std::vector<char>, 4> is_paired;
  for (std::size_t d = 0; d < 4; ++d) is_paired[d].assign(simplices[d].size(), 0);
  for (std::size_t d = 3; d > 0; --d) {
    std::vector<Column> by_lowest(simplices[d - 1].size());
    for (std::size_t i = 0; i < simplices[d].size(); ++i) {
      if (is_paired[d][i] != 0) continue;
      Column column;
      for (std::size_t k = 0; k <= d; ++k) {
        Simplex face = simplices[d][i];
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
        column.push_back(places[d - 1].at(face));
      }
      std::sort(column.begin(), column.end());
      while (!column.empty() && !by_lowest[column.back()].empty())
        column = added(column, by_lowest[column.back()]);
      if (column.empty()) continue;
      const std::size_t low = column.back();
      is_paired[d][i] = is_paired[d - 1][low] = 1;
      if (births[d - 1][low] > births[d][i])
        result.pairs[d - 1].push_back({births[d - 1][low], births[d][i]});
      by_lowest[low] = std::move(column);
    }
  }
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < simplices[d].size(); ++i)
      if (is_paired[d][i] == 0) result.pairs[d].push_back({births[d][i], -2});
  return result;
}

}  // namespace tensortopo::test
