// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/small_tensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tensortopo::detail {
namespace {

using Tensor = SymmetricTensor<double>;

std::array<double, 6> components(const Tensor& t) { return {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}; }

/// The norm of the deviator, about.
double deviator_size(const Tensor& t) {
  const double mean = t.xx / 3 + t.yy / 3 + t.zz / 3;
  const std::array<double, 9> all{t.xx - mean, t.yy - mean, t.zz - mean, t.xy, t.yz,
                                  t.xz,        t.xy,        t.yz,        t.xz};
  double largest = 0, sum = 0;
  for (const double x : all) largest = std::max(largest, std::abs(x));
  if (!(largest > 0)) return 0;
  for (const double x : all) sum += x / largest * (x / largest);
  return largest * std::sqrt(sum);
}

}  // namespace

std::size_t take_as_zero(TetMesh& mesh, double least) {
  std::size_t changed = 0;
  for (Tensor& t : mesh.tensors) {
    const Tensor before = t;
    for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      if (std::abs(*x) < least) *x = 0;
    if (deviator_size(t) < least) {
      const double mean = t.xx / 3 + t.yy / 3 + t.zz / 3;
      t = {mean, mean, mean, 0, 0, 0};
    }
    changed += t != before;
  }
  return changed;
}

std::string note_of_nearly_isotropic(const TetMesh& mesh) {
  constexpr double kShare = 1e-9;
  std::vector<double> norms(mesh.tensors.size());
  std::transform(mesh.tensors.begin(), mesh.tensors.end(), norms.begin(), deviator_size);
  std::vector<char> is_small(norms.size(), 0);
  for (const auto& tet : mesh.tets) {
    double largest = 0;
    for (const auto v : tet) largest = std::max(largest, norms[static_cast<std::size_t>(v)]);
    for (const auto v : tet) {
      const double norm = norms[static_cast<std::size_t>(v)];
      if (norm > 0 && norm < kShare * largest) is_small[static_cast<std::size_t>(v)] = 1;
    }
  }
  const auto count = std::count(is_small.begin(), is_small.end(), 1);
  if (count == 0) return {};
  double largest = 0;
  for (const Tensor& t : mesh.tensors)
    for (const double x : components(t)) largest = std::max(largest, std::abs(x));
  const auto first = std::find(is_small.begin(), is_small.end(), 1) - is_small.begin();
  return fmt::format(
      "{} {} of less than 1e-9 of a neighbour's (first: {}); if that is rounding, --zero-below "
      "{:.0e} takes such tensors as isotropic",
      count, count == 1 ? "vertex has a deviator" : "vertices have deviators", first,
      kShare * largest);
}

NotFinite find_not_finite(TetMesh& mesh) {
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const auto v : tet) is_used[static_cast<std::size_t>(v)] = 1;
  NotFinite found;
  for (std::size_t v = 0; v < mesh.tensors.size(); ++v) {
    const auto all = components(mesh.tensors[v]);
    if (std::all_of(all.begin(), all.end(), [](double x) { return std::isfinite(x); })) continue;
    if (is_used[v] == 0)
      mesh.tensors[v] = {};
    else if (found.count++ == 0)
      found.vertex = v;
  }
  return found;
}

}  // namespace tensortopo::detail
