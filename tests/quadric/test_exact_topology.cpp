// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The extracted level in single tetrahedra, against exact counts that take another way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "exact_level.hpp"
#include "support/generators.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo::test {
namespace {

/// Small fractions: with integer tensors, many are critical values or values at vertices.
InvariantLevel drawn_level(int bound) {
  const auto invariant =
      *rc::gen::element(Invariant::magnitude, Invariant::deviator_magnitude, Invariant::anisotropy);
  if (invariant == Invariant::anisotropy) {
    const int below = *rc::gen::inRange(2, 9);
    return level_at(invariant, Rational(*rc::gen::inRange(1, below), below));
  }
  return level_at(invariant, Rational(*rc::gen::inRange(1, 2 * bound), *rc::gen::inRange(1, 4)));
}

void expect_exact(const TetTensors& tensors, const InvariantLevel& level) {
  const auto whole = extract_invariant_surface(reference_tet_mesh(tensors), level, in_pieces(1));
  if (!whole.zero_tensor.empty()) {
    RC_ASSERT(level.invariant() == Invariant::anisotropy);
    RC_ASSERT(whole.surface.triangles.empty());
    for (const int pieces : {2, 3})
      RC_ASSERT(extract_invariant_surface(reference_tet_mesh(tensors), level, in_pieces(pieces))
                    .zero_tensor == whole.zero_tensor);
    return;
  }
  const auto known = surface_invariants(whole.surface);
  RC_ASSERT(known.manifold);
  RC_ASSERT(known.consistently_oriented);
  long euler = 0;
  std::array<int, 6> crossings{};
  for (const int nappe : nappes(level.invariant())) {
    const ExactLevel exact(tensors, level, nappe);
    euler += exact.euler_characteristic();
    for (std::size_t e = 0; e < 6; ++e)
      crossings[e] += exact.crossings(kTetEdges[e][0], kTetEdges[e][1]);
  }
  RC_ASSERT(known.euler_characteristic == euler);
  std::array<int, 6> found{};
  for (std::size_t v = 0; v < whole.surface.points.size(); ++v)
    if (whole.surface.carrier[v] == Carrier::edge) {
      const auto& ends = whole.surface.carrier_vertices[v];
      ++found[static_cast<std::size_t>(tet_edge(ends[0], ends[1]))];
    }
  RC_ASSERT(found == crossings);
  // Finer pieces show nothing new.
  for (const int pieces : {2, 3, 5}) {
    const auto fine =
        extract_invariant_surface(reference_tet_mesh(tensors), level, in_pieces(pieces));
    RC_ASSERT(topology(fine) == topology(whole));
  }
}

RC_GTEST_PROP(ExactTopology, OfSmallIntegerTensorsIsThatOfRationalCounts, ()) {
  const int bound = *rc::gen::element(1, 2, 9);
  const auto tensors = (*small_integer_tet(bound)).tensors;
  expect_exact(tensors, drawn_level(bound));
}

RC_GTEST_PROP(ExactTopology, OfRealTensorsIsThatOfRationalCounts, ()) {
  const auto tensors = (*normal_tet()).tensors;
  expect_exact(tensors, drawn_level(2));
}

/// Tensors a small way around one of the level: flat quadrics, all kinds of edges and faces met
/// without their corners.
RC_GTEST_PROP(ExactTopology, OfNearlyEqualTensorsIsThatOfRationalCounts, ()) {
  auto tensors = (*normal_tet()).tensors;
  const auto level = drawn_level(2);
  const double v = level.approx();
  auto middle = tensors[0];
  if (level.invariant() == Invariant::anisotropy) {
    const double third = trace(middle) / 3;
    const SymmetricTensor<double> isotropic{third, third, third, 0, 0, 0};
    const auto rest = middle - isotropic;
    const double wanted = std::abs(third) * std::sqrt(3.0) * v / std::sqrt(1 - v * v);
    middle = isotropic + (wanted / std::sqrt(inner(rest, rest))) * rest;
  } else {
    middle = (v / invariant_of(level.invariant(), middle)) * middle;
  }
  const double size = std::ldexp(1.0, -*rc::gen::inRange(0, 30));
  for (auto& t : tensors) t = middle + size * t;
  expect_exact(tensors, level);
}

RC_GTEST_PROP(ExactTopology, IsThatOfALevelJustAbove, ()) {
  const int bound = *rc::gen::element(1, 2);
  const auto mesh = reference_tet_mesh((*small_integer_tet(bound)).tensors);
  const auto level = drawn_level(bound);
  const Rational tiny(1, boost::multiprecision::mpz_int(1) << 400);
  const auto above = level_at(level.invariant(), Rational(level.text()) + tiny);
  const auto here = extract_invariant_surface(mesh, level, in_pieces(2));
  const auto there = extract_invariant_surface(mesh, above, in_pieces(2));
  RC_ASSERT(here.zero_tensor == there.zero_tensor);
  RC_ASSERT(topology(here) == topology(there));
}

}  // namespace
}  // namespace tensortopo::test
