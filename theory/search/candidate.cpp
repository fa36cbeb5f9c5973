// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "candidate.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::theory {
namespace {

std::array<int, 4> random_rotation(Random& random) {
  return {random.nonzero(5), random.integer(-5, 5), random.integer(-5, 5), random.integer(-5, 5)};
}

// A and B of the singularities, if they are rational.
std::optional<std::array<Rational, 2>> singularity(int high, int middle) {
  const long low = -high - middle, width = high - low;
  const auto share = [width](long gap) -> std::optional<Rational> {
    const long root = std::lround(std::sqrt(static_cast<double>(gap * width)));
    if (root * root != gap * width) return std::nullopt;
    return Rational(root) / Rational(width);
  };
  const auto a = share(high - middle), b = share(middle - low);
  if (!a || !b) return std::nullopt;
  return std::array{*a, *b};
}

}  // namespace

Trial trial_of(const Candidate& c) {
  Trial trial;
  trial.random = Random(c.seed);
  if (c.high > 0) {
    trial.frame = Frame{{Rational(c.high), Rational(c.middle), Rational(-c.high - c.middle)},
                        basis_of_quaternion(c.rotation),
                        singularity(c.high, c.middle)};
    Random random(c.seed);
    trial.field =
        field_orthogonal_to(tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors), random);
    return trial;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto entry = [&](std::size_t j) { return Rational(c.entries[5 * i + j]); };
    trial.field.vertex[i] = {entry(0), entry(1), entry(2), entry(3), entry(4)};
  }
  return trial;
}

Candidate random_candidate(Random& random) {
  Candidate c;
  c.seed = static_cast<std::uint32_t>(random.integer(0, 1 << 30));
  const int kind = random.integer(0, 3);
  if (kind >= 2) {
    c.high = random.integer(2, 40);
    c.middle = random.integer(0, c.high);
    // With rational singularities: A and B 3/5 and 4/5, 5/13 and 12/13, 7/25 and 24/25.
    if (kind == 3) {
      const std::array<std::array<int, 2>, 3> known = {{{34, 7}, {194, 119}, {674, 527}}};
      const auto& [high, middle] = known[static_cast<std::size_t>(random.integer(0, 2))];
      c.high = high, c.middle = middle;
    }
    c.rotation = random_rotation(random);
    return c;
  }
  for (int& entry : c.entries) {
    entry = random.integer(-9, 9);
    if (kind == 1 && random.integer(0, 2) > 0) entry = 0;
  }
  return c;
}

Candidate changed(const Candidate& candidate, Random& random) {
  Candidate c = candidate;
  if (random.integer(0, 9) == 0) c.seed = static_cast<std::uint32_t>(random.integer(0, 1 << 30));
  if (c.high == 0) {
    int& entry = c.entries[static_cast<std::size_t>(random.integer(0, 19))];
    switch (random.integer(0, 3)) {
      case 0:
        entry = 0;
        break;
      case 1:
        for (int& e : c.entries) e *= std::abs(e) < 200 ? 2 : 1;
        ++entry;
        break;
      default:
        entry += random.nonzero(3);
    }
    return c;
  }
  switch (random.integer(0, 3)) {
    case 0:
      c.rotation = random_rotation(random);
      break;
    case 1:
      c.high = std::min(2 * c.high, 400);
      break;
    case 2:
      c.middle = std::min(c.middle + random.integer(1, 1 + c.high / 4), c.high);
      break;
    default:
      c.middle = std::max(c.middle - random.integer(1, 1 + c.high / 4), 0);
  }
  return c;
}

double distance_from_exceptional(const Candidate& candidate) {
  const Trial trial = trial_of(candidate);
  const auto direction = characteristic_direction(trial.field);
  const SymmetricTensor<Rational> n = to_tensor(direction);
  if (n == SymmetricTensor<Rational>{}) return 0;
  const Rational size = inner(n, n), det = determinant(n);
  const double mode =
      Rational(Rational(54) * det * det / (size * size * size)).convert_to<double>();
  // The volume of the vertex tensors, by Gram-Schmidt.
  double volume = 1;
  std::vector<SymmetricTensor<Rational>> before;
  for (const auto& d : trial.field.vertex) {
    SymmetricTensor<Rational> t = to_tensor(d);
    const double whole = inner(t, t).convert_to<double>();
    for (const auto& b : before) t = t - Rational(inner(t, b) / inner(b, b)) * b;
    volume *= std::sqrt(inner(t, t).convert_to<double>() / whole);
    before.push_back(t);
  }
  return std::min({mode, 1 - mode, volume});
}

std::string text(const Candidate& c) {
  const auto list = [](const auto& numbers) {
    std::string words;
    for (const int n : numbers) words += (words.empty() ? "{" : ", ") + std::to_string(n);
    return words + "}";
  };
  const std::string seed = std::to_string(c.seed) + "u";
  if (c.high == 0) return "{.entries = {" + list(c.entries) + "}, .seed = " + seed + "}";
  return "{.high = " + std::to_string(c.high) + ", .middle = " + std::to_string(c.middle) +
         ", .rotation = {" + list(c.rotation) + "}, .seed = " + seed + "}";
}

}  // namespace tensortopo::theory
