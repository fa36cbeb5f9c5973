// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

// What the double tier decides is what rationals say. Built with every level of optimisation and,
// where there is a second compiler, with that too; run with flush-to-zero and another rounding mode
// set beforehand, as a library built with -ffast-math would leave them.
//
// Arguments: how many times the usual number of trials (default 1).

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "support/oracles/exact_increase.hpp"
#include "support/fields/random_fields.hpp"
#include "extract/level/exact_side.hpp"
#include "extract/level/level.hpp"
#include "extract/level/proofs/likely_direction.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {
namespace {

struct Counts {
  const char* name;
  long calls = 0, decided = 0, wrong = 0;
  double least_share = 0;  ///< of calls that must be decided
  long unproved_wrong = 0;  ///< of signs taken as they come, without a bound

  bool is_good() const {
    const double share = static_cast<double>(decided) / static_cast<double>(calls);
    std::cout << name << ": " << calls << " calls, " << 100 * share << " % decided in double, "
              << wrong << " wrong";
    if (unproved_wrong > 0) std::cout << " (" << unproved_wrong << " without a bound)";
    std::cout << '\n';
    return wrong == 0 && share >= least_share;
  }
};

constexpr const char* kModes[] = {"0",     "1/1000000", "1/10",   "-1/2",
                                  "143/343", "9/10",      "-99/100", "999/1000"};

ModeValue mode_at(long trial) {
  return ModeValue::parse(kModes[static_cast<std::size_t>(trial) % std::size(kModes)]);
}

/// Every entry times 2^e: exact.
SymmetricTensor<double> scaled(const SymmetricTensor<double>& t, int e) {
  return {std::ldexp(t.xx, e), std::ldexp(t.yy, e), std::ldexp(t.zz, e),
          std::ldexp(t.xy, e), std::ldexp(t.yz, e), std::ldexp(t.xz, e)};
}

TetMesh bare_mesh(const TetTensors& tensors) {
  TetMesh mesh;
  mesh.tensors.assign(tensors.begin(), tensors.end());
  mesh.points.resize(tensors.size());
  return mesh;
}

/// Independent, quantised, or of very different lengths.
TetTensors draw(Random& random, long trial) {
  TetTensors tensors = random.tet_tensors();
  if (trial % 3 == 1)
    for (auto& t : tensors) t = rounded(t, 3);
  if (trial % 3 == 2)
    for (auto& t : tensors) t = scaled(t, random.integer(-300, 300));
  return tensors;
}

class Sides {
 public:
  explicit Sides(const TetTensors& tensors) : mesh_(bare_mesh(tensors)), field_(mesh_) {
    for (std::size_t i = 0; i < 4; ++i) corners_[i] = field_.tensors[i];
  }

  /// Counts one call at some weights; the exact side is the answer.
  Sign ask(const std::array<double, 4>& weights, const ModeValue& mode, const Level<double>& level,
           Counts& counts) const {
    double total = 0;
    for (const double w : weights) total += w;
    const Verdict verdict = side_of_level(tensor_at(corners_, weights), level, total);
    const Sign exact = exact_side_of_level(mesh_.tensors, field_.exponents, weights, mode);
    ++counts.calls;
    counts.unproved_wrong +=
        (level_function(tensor_at(corners_, weights), level) > 0) != (exact == Sign::positive);
    if (verdict == Verdict::unknown) return exact;
    ++counts.decided;
    counts.wrong += (verdict == Verdict::positive) != (exact == Sign::positive) ||
                    exact == Sign::zero;
    return exact;
  }

 private:
  TetMesh mesh_;
  ScaledField<double> field_;
  std::array<Deviator<double>, 4> corners_;
};

void try_sides(long trials, Counts& anywhere, Counts& near_level) {
  Random random(20241201);
  for (long trial = 0; trial < trials; ++trial) {
    const FloatingPointEnvironment environment;
    const auto mode = mode_at(trial);
    const auto level = make_level<double>(mode);
    const Sides sides(draw(random, trial));
    std::array<double, 4> from{}, to{};
    for (std::size_t i = 0; i < 4; ++i) {
      from[i] = random.uniform();
      to[i] = random.uniform();
    }
    const Sign first = sides.ask(from, mode, level, anywhere);
    const Sign last = sides.ask(to, mode, level, anywhere);
    if (first == last) continue;
    // Halve towards the level: the last questions are as hard as doubles can ask.
    for (int step = 0; step < 60; ++step) {
      std::array<double, 4> middle;
      for (std::size_t i = 0; i < 4; ++i) middle[i] = from[i] + 0.5 * (to[i] - from[i]);
      (sides.ask(middle, mode, level, near_level) == first ? from : to) = middle;
    }
  }
}

template <class Polynomial>
bool all_have_sign(const Polynomial& p, int sign) {
  for (const auto& c : p.coefficients)
    if (sign * c <= 0) return false;
  return true;
}

void try_forms(long trials, Counts& empty, Counts& increasing) {
  Random random(20241202);
  for (long trial = 0; trial < trials; ++trial) {
    const FloatingPointEnvironment environment;
    const auto mode = mode_at(trial);
    const auto level = make_level<double>(mode);
    TetTensors tensors;
    tensors[0] = random.tensor();
    const double spread = std::ldexp(1.0, -(static_cast<int>(trial) % 12));
    for (std::size_t i = 1; i < 4; ++i) tensors[i] = tensors[0] + spread * random.tensor();
    const TetMesh mesh = bare_mesh(tensors);
    const ScaledField<double> field(mesh);
    std::array<Deviator<double>, 4> rounded_corners;
    std::array<Deviator<Rational>, 4> exact_corners;
    for (std::size_t i = 0; i < 4; ++i) {
      rounded_corners[i] = field.tensors[i];
      const auto t = scaled(tensors[i], field.exponents[i]);
      exact_corners[i] = deviator(tensor_cast<Rational>(t));
    }
    const auto forms = mode_forms(rounded_corners);
    const auto exact_forms = mode_forms(exact_corners);
    const double norm = largest_norm(rounded_corners);

    const auto bounds = norm_bounds(forms);
    const LevelIncrease<double, 4> increase(forms, bounds, level);
    const auto direction = likely_direction(increase, kLongSearch, trial % 2 != 0);
    const Verdict increases = detail::increases_along(increase, direction, norm, 1);
    ++increasing.calls;
    increasing.decided += increases != Verdict::unknown;
    const bool truly =
        truly_increases(exact_forms, bounds, to_scalar<Rational>(mode), direction);
    increasing.wrong += (increases == Verdict::positive && !truly) ||
                        (increases == Verdict::negative && truly);

    const Verdict is_empty = detail::is_empty(forms, bounds, level, norm, 1);
    ++empty.calls;
    empty.decided += is_empty != Verdict::unknown;
    const bool truly_none = truly_empty(exact_forms, bounds, to_scalar<Rational>(mode)) ||
                            all_have_sign(exact_forms.determinant, -level.sign);
    empty.wrong += (is_empty == Verdict::positive && !truly_none) ||
                   (is_empty == Verdict::negative && truly_none);
  }
}

/// What code that ran before may have left.
void spoil_the_environment() {
  std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
  _mm_setcsr(_mm_getcsr() | 0x8040u);
#endif
}

}  // namespace

int run(long factor) {
  spoil_the_environment();
  Counts anywhere{"sides of the level at random", 0, 0, 0, 0.99};
  Counts near_level{"sides next to the level"};
  Counts empty{"simplices without level", 0, 0, 0, 0.99};
  Counts increasing{"simplices in which the mode increases", 0, 0, 0, 0.99};
  try_sides(1500 * factor, anywhere, near_level);
  try_forms(300 * factor, empty, increasing);
  const bool good = anywhere.is_good() & near_level.is_good() & empty.is_good() &
                    increasing.is_good();
  // If plain doubles are never wrong, the questions were too easy.
  return good && near_level.unproved_wrong > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace tensortopo::test

int main(int argc, char** argv) {
  return tensortopo::test::run(argc > 1 ? std::atol(argv[1]) : 1);
}
