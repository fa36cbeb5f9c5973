// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/prepared_field.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "extract/level/proofs/screen.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

template <class Body>
void for_each(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace

template <class Scalar>
PreparedField<Scalar>::PreparedField(const TetMesh& given, Use use)
    : canonical(std::make_shared<const CanonicalMesh>(canonical_mesh(given))),
      field(canonical->mesh),
      norms(given.points.size()),
      lode_angles(given.points.size(), 0) {
  const TetMesh& m = canonical->mesh;
  if constexpr (!std::is_same_v<Scalar, double>) {
    rounded_tensors.resize(m.points.size());
    for_each(m.points.size(),
             [&](std::size_t v) { rounded_tensors[v] = rounded(std::array{field.tensors[v]})[0]; });
  }
  for_each(m.points.size(), [&](std::size_t v) {
    norms[v] = std::sqrt(norm_form(tensors()[v]));
    if (!field.is_zero[v]) lode_angles[v] = screen::lode_angle(tensors()[v]);
  });
  if (use == Use::one_mode) return;
  lode_ranges.assign(m.tets.size(), {-1, 4});
  for_each(m.tets.size(), [&](std::size_t t) {
    std::array<Deviator<double>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = as_size(m.tets[t][i]);
      if (field.is_zero[v]) return;
      corners[i] = tensors()[v];
    }
    const auto range = screen::lode_range(corners);
    // To float outwards.
    lode_ranges[t] = {std::nextafter(static_cast<float>(range[0]), -8.0f),
                      std::nextafter(static_cast<float>(range[1]), 8.0f)};
  });
}

#define TENSORTOPO_INSTANTIATE(Scalar) template struct PreparedField<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
