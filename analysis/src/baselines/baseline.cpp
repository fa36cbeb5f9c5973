// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/analysis/baseline.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "baselines/a_patches.hpp"
#include "baselines/hybrid.hpp"
#include "baselines/marching.hpp"
#include "extract/level/mode_forms.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

namespace {

using namespace baselines;

template <class Body>
std::vector<std::vector<SoupTriangle>> for_each_tet(const TetMesh& mesh, const Body& body) {
  std::vector<std::vector<SoupTriangle>> by_tet(mesh.tets.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, by_tet.size(), 512),
                    [&](const auto& range) {
                      for (std::size_t t = range.begin(); t != range.end(); ++t)
                        body(t, by_tet[t]);
                    });
  return by_tet;
}

SurfaceMesh by_marching(const TetMesh& mesh, double mu) {
  std::vector<double> mode(mesh.points.size());
  for (std::size_t v = 0; v < mode.size(); ++v)
    mode[v] = mode_if_defined(deviator(mesh.tensors[v])).value_or(-2);
  return merge(for_each_tet(mesh,
                            [&](std::size_t t, std::vector<SoupTriangle>& out) {
                              const auto& v = mesh.tets[t];
                              std::array<bool, 4> above;
                              for (std::size_t i = 0; i < 4; ++i)
                                above[i] = mode[as_size(v[i])] > mu;
                              march(above, static_cast<SurfaceMesh::Index>(t),
                                    [&](std::size_t i, std::size_t j) {
                                      const auto from = as_size(std::min(v[i], v[j]));
                                      const auto to = as_size(std::max(v[i], v[j]));
                                      const double s = (mu - mode[from]) / (mode[to] - mode[from]);
                                      const auto &p = mesh.points[from], &q = mesh.points[to];
                                      return p + s * (q - p);
                                    },
                                    out);
                            }),
               mu);
}

/// Whether the determinant has Bernstein coefficients of both signs.
bool may_be_neutral(const std::array<FieldPoint, 4>& corners) {
  std::array<Deviator<double>, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) tensors[i] = corners[i].tensor;
  const auto c = mode_forms(tensors).determinant.coefficients;
  return std::any_of(c.begin(), c.end(), [](double x) { return x > 0; }) &&
         std::any_of(c.begin(), c.end(), [](double x) { return x < 0; });
}

/// Runs `add` on every tetrahedron that has a deviator, its corners scaled.
template <class Add>
SurfaceMesh by_tets(const TetMesh& mesh, double mu, const Add& add) {
  return merge(for_each_tet(mesh,
                            [&](std::size_t t, std::vector<SoupTriangle>& out) {
                              std::array<FieldPoint, 4> corners;
                              double largest = 0;
                              for (std::size_t i = 0; i < 4; ++i) {
                                const auto v = as_size(mesh.tets[t][i]);
                                corners[i] = {deviator(mesh.tensors[v]), mesh.points[v]};
                                largest = std::max(largest, norm_form(corners[i].tensor));
                              }
                              if (!(largest > 0)) return;
                              // Degree six overflows early.
                              const double scale = std::exp2(-std::ilogb(std::sqrt(largest)));
                              for (auto& corner : corners) corner.tensor = scale * corner.tensor;
                              add(corners, static_cast<SurfaceMesh::Index>(t), out);
                            }),
               mu);
}

SurfaceMesh by_a_patches(const TetMesh& mesh, const ModeValue& mu,
                         const BaselineOptions& options) {
  const auto level = make_level<double>(mu);
  return by_tets(mesh, mu.approx(),
                 [&](const auto& corners, SurfaceMesh::Index tet, std::vector<SoupTriangle>& out) {
                   add_a_patches(corners, tet, level, options, out);
                 });
}

SurfaceMesh by_hybrid(const TetMesh& mesh, const BaselineOptions& options) {
  const auto level = make_level<double>(ModeValue());
  return by_tets(mesh, 0,
                 [&](const auto& corners, SurfaceMesh::Index tet, std::vector<SoupTriangle>& out) {
                   if (!may_be_neutral(corners)) return;
                   if (!add_hybrid(corners, tet, options.flatness, out))
                     add_a_patches(corners, tet, level, options, out);
                 });
}

}  // namespace

SurfaceMesh baseline_surface(Baseline method, const TetMesh& mesh, const ModeValue& mu,
                             const BaselineOptions& options) {
  if (std::abs(mu.approx()) >= 1)
    throw std::invalid_argument("mode surfaces exist for |mode| < 1, not for " + mu.text());
  switch (method) {
    case Baseline::marching:
      return by_marching(mesh, mu.approx());
    case Baseline::a_patches:
      return by_a_patches(mesh, mu, options);
    case Baseline::hybrid:
      break;
  }
  if (mu.sign() != 0)
    throw std::invalid_argument("the hybrid method extracts neutral surfaces (mode 0) only, not " +
                                mu.text());
  return by_hybrid(mesh, options);
}

}  // namespace tensortopo
