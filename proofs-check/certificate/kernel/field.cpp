// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "field.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {

Tensor<Ball> enclosure(const Tensor<mpz_class>& m, long& shift) {
  shift = 0;
  for (const mpz_class& x : m)
    shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
  Tensor<Ball> result;
  for (std::size_t k = 0; k < m.size(); ++k) result[k] = ball_of(m[k], shift);
  return result;
}

Field::Field(const Input& input, Multiples multiples)
    : input_(input), multiples_(std::move(multiples)) {
  for (std::uint32_t v = 0; v < input.tensors.size(); ++v) {
    constexpr int kNone = 2000;
    int lowest = multiples_.one == 0 ? kNone : 0;
    for (const double x : input.tensors[v]) {
      int e = 0;
      std::frexp(x, &e);
      if (x != 0) lowest = std::min(lowest, e - 53);
    }
    exponents_.push_back(lowest == kNone ? 0 : lowest);
    shifts_.push_back(0);
    const Tensor<mpz_class> t = exact(v);
    balls_.push_back(enclosure(t, shifts_.back()));
    is_zero_.push_back(std::all_of(t.begin(), t.end(), [](const auto& x) { return x == 0; }));
  }
}

Tensor<mpz_class> Field::exact(std::uint32_t vertex) const {
  std::array<mpz_class, 6> t;
  for (std::size_t k = 0; k < 6; ++k) {
    int e = 0;
    const double mantissa = std::frexp(input_.tensors[vertex][k], &e);
    t[k] = std::ldexp(mantissa, 53);  // an integer
    if (t[k] != 0) t[k] <<= static_cast<unsigned long>(e - 53 - exponents_[vertex]);
    t[k] *= multiples_.tensor;
  }
  return {
      2 * t[0] - t[1] - t[2], 2 * t[1] - t[0] - t[2], 2 * t[2] - t[0] - t[1],
      3 * t[4], 3 * t[5], 3 * t[3],
      multiples_.trace ? mpz_class(t[0] + t[1] + t[2]) : 0,
      multiples_.one << static_cast<unsigned long>(multiples_.one == 0 ? 0 : -exponents_[vertex])};
}

}  // namespace certificate
