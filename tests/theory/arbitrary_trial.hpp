// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <ostream>
#include <vector>

#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory::test {

/// What a trial is made of, in small numbers that shrink: the simplest field that still violates a
/// law is the one that is shown.
struct TrialParts {
  int stratum = 0;            ///< 0 to 2 general, then each special kind
  std::vector<int> entries;   ///< of the tensors, 20 of them
  std::vector<int> rotation;  ///< a quaternion, 4 of them
  int high = 1, middle = 0;   ///< eigenvalues of a known characteristic tensor
  std::uint32_t seed = 0;     ///< of the check's own choices
};

inline Trial trial_of(const TrialParts& parts) {
  Trial trial;
  trial.random = Random(parts.seed);
  auto& t = trial.field.vertex;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto entry = [&](std::size_t j) { return Rational(parts.entries[5 * i + j]); };
    t[i] = {entry(0), entry(1), entry(2), entry(3), entry(4)};
  }
  const auto with_frame = [&](int high, int middle) {
    std::array<int, 4> q{};
    std::copy(parts.rotation.begin(), parts.rotation.end(), q.begin());
    if (std::all_of(q.begin(), q.end(), [](int x) { return x == 0; })) q[0] = 1;
    trial.frame = Frame{{Rational(high), Rational(middle), Rational(-(high + middle))},
                        basis_of_quaternion(q),
                        std::nullopt};
    Random random(parts.seed);
    trial.field =
        field_orthogonal_to(tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors), random);
  };
  const int high = std::max(parts.high, parts.middle), middle = std::min(parts.high, parts.middle);
  switch (parts.stratum) {
    case 3:  // a zero tensor at a vertex
      t[3] = {};
      break;
    case 4:  // a plane of symmetry
      for (auto& d : t) d.yz = d.xz = 0;
      break;
    case 5:  // dependent tensors
      t[3] = t[0] - t[1] + Rational(2) * t[2];
      break;
    case 6:  // dependent deviators, twice
      t[2] = t[0] + t[1];
      t[3] = t[0] - t[1];
      break;
    case 7:
      with_frame(high, middle);
      break;
    case 8:  // neutral
      with_frame(high, 0);
      break;
    case 9:  // planar degenerate
      with_frame(high, high);
      break;
    default:
      break;
  }
  return trial;
}

inline void showValue(const TrialParts& parts, std::ostream& out) {
  out << "stratum " << parts.stratum << ", field " << text(trial_of(parts).field) << ", seed "
      << parts.seed;
}

}  // namespace tensortopo::theory::test

template <>
struct rc::Arbitrary<tensortopo::theory::test::TrialParts> {
  static auto arbitrary() {
    using Parts = tensortopo::theory::test::TrialParts;
    const auto small = [](int bound) {
      return gen::resize(bound, gen::inRange(-bound, bound + 1));
    };
    return gen::build<Parts>(
        gen::set(&Parts::stratum, gen::inRange(0, 10)),
        gen::set(&Parts::entries, gen::container<std::vector<int>>(20, small(9))),
        gen::set(&Parts::rotation, gen::container<std::vector<int>>(4, small(5))),
        gen::set(&Parts::high, gen::inRange(1, 10)), gen::set(&Parts::middle, gen::inRange(1, 10)),
        gen::set(&Parts::seed, gen::arbitrary<std::uint32_t>()));
  }
};
