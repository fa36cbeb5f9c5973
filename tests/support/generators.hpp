// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "support/fields/random_fields.hpp"

/// RapidCheck generators of tensor fields. (Seeded fields without shrinking: random_fields.hpp.)

namespace tensortopo {

/// How RapidCheck and GoogleTest print a tensor: so that it reads back bit for bit.
inline void showValue(const SymmetricTensor<double>& t, std::ostream& out) {
  out << test::exact_text(t);
}
inline void PrintTo(const SymmetricTensor<double>& t, std::ostream* out) { showValue(t, *out); }

}  // namespace tensortopo

namespace tensortopo::test {

/// Tensors at the vertices of one tetrahedron, with a print-out to paste into a test.
struct TetSample {
  TetTensors tensors{};
};

inline std::ostream& operator<<(std::ostream& out, const TetSample& sample) {
  return out << exact_text(sample.tensors);
}

/// Tensor with integer entries in [-bound, bound]; shrinks towards zero entries.
inline rc::Gen<SymmetricTensor<double>> small_integer_tensor(int bound = 9) {
  // Numbers from 0 on, which is the end that they shrink to, count 0, 1, -1, 2, -2 and so on.
  return rc::gen::map(rc::gen::container<std::array<int, 6>>(rc::gen::inRange(0, 2 * bound + 1)),
                      [](const std::array<int, 6>& drawn) {
                        const auto entry = [](int k) {
                          return static_cast<double>(k % 2 ? (k + 1) / 2 : -(k / 2));
                        };
                        return SymmetricTensor<double>{entry(drawn[0]), entry(drawn[1]),
                                                       entry(drawn[2]), entry(drawn[3]),
                                                       entry(drawn[4]), entry(drawn[5])};
                      });
}

/// Four such tensors. Ties, equal corners and deficient ranks are common here.
inline rc::Gen<TetSample> small_integer_tet(int bound = 9) {
  return rc::gen::map(rc::gen::container<TetTensors>(small_integer_tensor(bound)),
                      [](const TetTensors& tensors) { return TetSample{tensors}; });
}

/// Four independent normal tensors, all bits in use; shrinks by dropping binary places, down to
/// small integers.
inline rc::Gen<TetSample> normal_tet() {
  const auto drawn =
      rc::gen::map(rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()),
                   [](std::uint64_t seed) { return TetSample{Random(seed).tet_tensors()}; });
  return rc::gen::shrink(drawn, [](const TetSample& sample) {
    std::vector<TetSample> simpler;
    for (const int places : {0, 1, 2, 3, 4, 6, 8, 12, 20, 30}) {
      TetSample candidate;
      for (std::size_t i = 0; i < 4; ++i) {
        candidate.tensors[i] = rounded(sample.tensors[i], places);
      }
      if (candidate.tensors != sample.tensors) simpler.push_back(candidate);
    }
    return rc::seq::fromContainer(simpler);
  });
}

/// A signed mode in steps of a thousandth, 0 < |mode| <= limit; shrinks towards 1/1000.
inline rc::Gen<double> mode_value(double limit = 0.99) {
  const int steps = static_cast<int>(limit * 1000 + 0.5);
  return rc::gen::map(rc::gen::inRange(0, 2 * steps),
                      [](int k) { return (k % 2 == 0 ? 1 : -1) * (k / 2 + 1) / 1000.0; });
}

}  // namespace tensortopo::test
